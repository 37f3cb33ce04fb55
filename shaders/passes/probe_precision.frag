// One row of a table per pixel, as probe.frag, with everything that is included in another precision: selected.glsl defines PROBE_VALUE and
// VALUE3, a vec3 of that precision. The value leaves as a float and what the float left of it, because targets hold no doubles.
#include "shared/bindings.h"
#include "shared/probe.h"
#include "selected.glsl"

layout(set = 0, binding = kBindProbeRows, scalar) readonly buffer ProbeRows { ProbeRow rows[]; };

layout(location = 0) out vec4 outValue;
layout(location = 1) out vec4 outRest;

void main()
{
    uint index = uint(gl_FragCoord.y) * kProbeWidth + uint(gl_FragCoord.x);
    outValue = vec4(0.0);
    outRest = vec4(0.0);
    if (index >= uint(rows.length()))
        return;
    ProbeRow row = rows[index];
    VALUE3 value = PROBE_VALUE;
    outValue = vec4(vec3(value), 1.0);
    outRest = vec4(vec3(value - VALUE3(outValue.xyz)), 0.0);
}
