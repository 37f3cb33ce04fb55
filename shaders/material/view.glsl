// The terms of a surface, of one light on it and of the light around it. Included after material/shade.glsl.
#include "shared/view.h"

#if defined(LIT) && defined(PUNCTUAL_LIGHTS)
struct LightAt
{
    vec3 l; // unit, towards the light
    vec3 irradiance;
};

// As shade() has it.
LobeAlbedo lobeOf(Surface s)
{
#ifdef DFG_TABLE
    vec4 albedo = directionalAlbedo(clamp(dot(s.normal, s.view), 0.0, 1.0), s.perceptualRoughness);
    return LobeAlbedo(albedo.w, albedo.y, 1.0, averageAlbedo(s.perceptualRoughness));
#else
    return LobeAlbedo(1.0, 0.0, 1.0, 1.0);
#endif
}

// The light number i, as its centre lights the surface.
LightAt lightAt(Surface s, uint i)
{
    Light light = lights[i];
    if (i < kDirectionalCount)
        return LightAt(light.direction, light.intensity);
    vec3 toLight = light.position - s.position;
    float distance2 = dot(toLight, toLight);
    vec3 l = distance2 > 0.0 ? toLight * inversesqrt(distance2) : s.normal;
    float attenuation = distanceAttenuation(distance2, light.inverseRange);
    if (i >= kDirectionalCount + kPointCount)
        attenuation *= coneAttenuation(dot(l, light.direction), light.coneScale, light.coneOffset);
    return LightAt(l, light.intensity * attenuation);
}

vec3 lightTerm(Surface s)
{
    LightAt light = lightAt(s, frame.viewLight);
    BrdfTerms terms = reflectedTerms(s, alphaOf(s), lobeOf(s), light.l);
    switch (frame.viewTerm) {
    case kViewLightIntensity:
        return light.irradiance;
    case kViewHalfVector:
        return terms.h;
    case kViewNoL:
        return vec3(max(dot(s.normal, light.l), 0.0));
    case kViewD:
        return vec3(terms.D);
    case kViewG1:
        return vec3(terms.G1);
    case kViewG:
        return vec3(terms.G);
    case kViewV:
        return vec3(terms.V);
    case kViewF0:
        return terms.F0;
    case kViewF:
        return terms.F;
    case kViewSpecular:
        return terms.specular;
    case kViewDiffuse:
        return terms.diffuse;
    case kViewBrdf:
        return terms.brdf;
    }
    return vec3(0.0);
}
#endif

#if defined(LIT) && defined(ENVIRONMENT_LIGHT)
vec3 environmentIrradiance(Surface s)
{
    return PI * frame.environmentIntensity * irradianceOverPi(frame.environmentFromWorld * s.normal);
}

#ifndef SPECULAR_SAMPLER
// Where the specular lobe is lit from: a lobe of scale 1 and bias 0 reflects the prefiltered light itself.
vec3 environmentPrefiltered(Surface s)
{
    vec3 n = frame.environmentFromWorld * s.normal;
    vec3 v = frame.environmentFromWorld * s.view;
    const vec4 whole = vec4(1.0, 0.0, 0.0, 1.0);
    LampIrradiance lamps; // the body's
    return frame.environmentIntensity * specularSums(n, v, alphaOf(s), s.perceptualRoughness, whole, lamps).scale;
}
#endif
#endif

vec3 viewedTerm(Surface s)
{
    switch (frame.viewTerm) {
    case kViewAlbedo:
        return s.baseColor;
    case kViewRoughness:
        return vec3(s.perceptualRoughness);
    case kViewMetallic:
        return vec3(s.metallic);
#if defined(LIT) && defined(ENVIRONMENT_LIGHT)
    case kViewIrradiance:
        return environmentIrradiance(s);
#ifndef SPECULAR_SAMPLER
    case kViewPrefiltered:
        return environmentPrefiltered(s);
#endif
#endif
#if defined(LIT) && defined(DFG_TABLE)
    case kViewDfg:
        return directionalAlbedo(clamp(dot(s.normal, s.view), 0.0, 1.0), s.perceptualRoughness).xyz;
#endif
    }
#if defined(LIT) && defined(PUNCTUAL_LIGHTS)
    return lightTerm(s);
#else
    return vec3(0.0);
#endif
}
