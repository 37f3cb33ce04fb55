// One row of a table per pixel: a fragment shader, because pictures are drawn by fragment shaders, and lavapipe treats numbers below the
// least normal one differently in compute shaders. selected.glsl defines PROBE_VALUE of `row`.
#include "shared/bindings.h"
#include "shared/probe.h"
#include "selected.glsl"

layout(set = 0, binding = kBindProbeRows, scalar) readonly buffer ProbeRows { ProbeRow rows[]; };

layout(location = 0) out vec4 outValue;

void main()
{
    uint index = uint(gl_FragCoord.y) * kProbeWidth + uint(gl_FragCoord.x);
    if (index >= uint(rows.length())) {
        outValue = vec4(0.0);
        return;
    }
    ProbeRow row = rows[index];
    outValue = vec4(PROBE_VALUE, 1.0);
}
