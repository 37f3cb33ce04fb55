// A surface's colour: premultiplied, scene-linear.
#include "selected.glsl"
#include "passes/surface_inputs.glsl"
#include "material/shade.glsl"

layout(location = 0) out vec4 outColor;

void main()
{
    readUniforms();
    Surface s = readSurface();
    applyAlphaMode(s, material.alphaCutoff);
    outColor = vec4(shade(s) * s.alpha, s.alpha);
}
