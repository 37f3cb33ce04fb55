// A surface's parameters, each in a picture of its own: what a shading formula was given.
#include "selected.glsl"
#include "passes/surface_inputs.glsl"

#if defined(SURFACE_SPHERE) || defined(SURFACE_PLANE)
uvec2 surfaceIds()
{
    return uvec2(instance.material, instance.object);
}
#else
layout(location = 12) flat in uvec2 inIds; // material, object

uvec2 surfaceIds()
{
    return inIds;
}
#endif

layout(location = 0) out vec4 outPositionDepth;      // relative to the eye; distance along the viewing axis
layout(location = 1) out vec4 outNormalRoughness;    // with normal map; perceptual roughness
layout(location = 2) out vec4 outGeometricMetallic;  // normal of the triangle; metallic
layout(location = 3) out vec4 outBaseColorOcclusion; // linear; 1 = open
layout(location = 4) out vec4 outEmissive;           // linear; 1 = covered
layout(location = 5) out vec4 outIds;                // object + 1, material + 1: 0 = nothing

void main()
{
    Surface s = readSurface();
    applyAlphaMode(s, material.alphaCutoff);
    outPositionDepth = vec4(s.position, dot(s.position, frame.forward));
    outNormalRoughness = vec4(s.normal, s.perceptualRoughness);
    outGeometricMetallic = vec4(s.geometricNormal, s.metallic);
    outBaseColorOcclusion = vec4(s.baseColor, s.occlusion);
    outEmissive = vec4(s.emissive, 1.0);
    uvec2 ids = surfaceIds();
    outIds = vec4(float(ids.y + 1u), float(ids.x + 1u), 0.0, 0.0);
}
