// A surface's parameters, each in a picture of its own: what a shading formula was given.
#include "selected.glsl"
#include "passes/surface_inputs.glsl"

layout(location = 0) out vec4 outPositionDepth;      // relative to the eye; distance along the viewing axis
layout(location = 1) out vec4 outNormalRoughness;    // with normal map; perceptual roughness
layout(location = 2) out vec4 outGeometricMetallic;  // normal of the triangle; metallic
layout(location = 3) out vec4 outBaseColorOcclusion; // linear; 1 = open
layout(location = 4) out vec4 outEmissive;           // linear; 1 = covered
layout(location = 5) out vec4 outIds;                // object + 1, material + 1: 0 = nothing

void main()
{
    Surface s = readSurface();
    applyAlphaMode(s, materials[s.ids.x].alphaCutoff);
    outPositionDepth = vec4(s.position, dot(s.position, frame.forward));
    outNormalRoughness = vec4(s.normal, s.perceptualRoughness);
    outGeometricMetallic = vec4(s.geometricNormal, s.metallic);
    outBaseColorOcclusion = vec4(s.baseColor, s.occlusion);
    outEmissive = vec4(s.emissive, 1.0);
    outIds = vec4(float(s.ids.y + 1u), float(s.ids.x + 1u), 0.0, 0.0);
}
