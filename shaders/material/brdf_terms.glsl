// What a function of shaders/brdf/model is given and returns: src/brdf/brdf_terms.h says what each member means.
#ifndef TORRANCE_MATERIAL_BRDF_TERMS
#define TORRANCE_MATERIAL_BRDF_TERMS

// Directional albedo of the lobe with F = 1; read only where the selection asks for it: multiple scattering, and a body weighted by albedo.
struct LobeAlbedo
{
    float E;        // at n.v
    float bias;     // of it what Schlick's (1 - v.h)^5 takes
    float ELight;   // at n.l
    float EAverage; // its mean over the hemisphere, weighted by the cosine
};

struct BrdfInput
{
    vec3 n, v, l; // unit, away from the surface
    vec3 baseColor;
    float metallic;
    float perceptualRoughness;
    float alpha; // max(perceptualRoughness^2, kMinAlpha)
    float ior;   // of the dielectric part
    LobeAlbedo lobe;
};

struct BrdfTerms
{
    vec3 h;
    float D;
    float G1;
    float G;
    float V;
    vec3 F0;
    vec3 F;
    vec3 specular;
    vec3 diffuse;
    vec3 brdf;
    float weight; // the light is multiplied by brdf * weight
};

BrdfTerms noTerms()
{
    const vec3 black = vec3(0.0);
    return BrdfTerms(black, 0.0, 0.0, 0.0, 0.0, black, black, black, black, black, 0.0);
}

#endif
