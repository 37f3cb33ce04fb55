// One term of the shading equation at each surface, as a number: frame.viewTerm says which. What is not there is 0.
#include "selected.glsl"
#include "passes/surface_inputs.glsl"
#include "material/shade.glsl"
#include "material/view.glsl"

layout(location = 0) out vec4 outColor;

void main()
{
    Surface s = readSurface();
    applyAlphaMode(s, material.alphaCutoff);
    outColor = vec4(viewedTerm(s) * s.alpha, s.alpha);
}
