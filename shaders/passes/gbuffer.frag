// A surface's parameters as 32-bit floats, for the lighting pass of its class (lighting.frag). Textures are sampled here, with derivatives of
// the surface's own.
#include "selected.glsl"
#include "passes/surface_inputs.glsl"

layout(constant_id = 0) const uint kLightingClass = 0; // of ShadingPlan::lightingClasses

layout(location = 0) out vec4 outPositionClass;      // relative to the eye; class + 1, where 0 = nothing
layout(location = 1) out vec4 outNormalRoughness;    // with normal map; perceptual roughness
layout(location = 2) out vec4 outBaseColorMetallic;  // linear
layout(location = 3) out vec4 outEmissiveOcclusion;  // linear; 1 = open

void main()
{
    Surface s = readSurface();
    applyAlphaMode(s, material.alphaCutoff);
    outPositionClass = vec4(s.position, float(kLightingClass + 1u));
    outNormalRoughness = vec4(s.normal, s.perceptualRoughness);
    outBaseColorMetallic = vec4(s.baseColor, s.metallic);
    outEmissiveOcclusion = vec4(s.emissive, s.occlusion);
}
