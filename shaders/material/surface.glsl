#ifndef MATERIAL_SURFACE_GLSL
#define MATERIAL_SURFACE_GLSL

// A point of a surface with all that shading needs.
struct Surface
{
    vec3 position;        // relative to the eye, metres
    vec3 geometricNormal; // unit, towards the viewer
    vec3 normal;          // unit, with the normal map, towards the viewer (bendNormal)
    vec3 view;            // unit, towards the viewer
    vec3 baseColor;       // linear
    float alpha;
    float metallic;
    float perceptualRoughness;
    float ior;       // of the dielectric part
    float occlusion; // 1 = open
    vec3 emissive;
};

#endif
