// Light that leaves a surface towards the viewer.
#if defined(UNLIT) || !defined(LIT)

// KHR_materials_unlit: base colour alone. Points and lines without normals: base colour plus emission (glTF 2.0, 3.9.7).
vec3 shade(Surface s)
{
    return s.baseColor + s.emissive;
}

#else

layout(constant_id = 0) const uint kDirectionalCount = 0;
layout(constant_id = 1) const uint kPointCount = 0;
layout(constant_id = 2) const uint kSpotCount = 0;

#include "light/punctual.glsl"
#include "environment/lighting.glsl"

float alphaOf(Surface s)
{
    return max(s.perceptualRoughness * s.perceptualRoughness, kMinAlpha);
}

#ifdef PUNCTUAL_LIGHTS
#include "light/light_block.glsl"

// Of directional light i. The first one's may be told by the vertex shader (passes/flat_uniforms.glsl).
#ifdef FLAT_UNIFORMS
vec3 lightDirection(uint i)
{
    return i == 0u ? flatLightDirection : lights[i].direction;
}

vec3 lightIntensity(uint i)
{
    return i == 0u ? flatLightIntensity : lights[i].intensity;
}
#else
vec3 lightDirection(uint i)
{
    return lights[i].direction;
}

vec3 lightIntensity(uint i)
{
    return lights[i].intensity;
}
#endif

// The surface's terms for light from `l`, unit.
BrdfTerms reflectedTerms(Surface s, float alpha, LobeAlbedo lobe, vec3 l)
{
#ifdef READS_LIGHT_ALBEDO
    lobe.ELight = directionalAlbedo(clamp(dot(s.normal, l), 0.0, 1.0), s.perceptualRoughness).w;
#endif
    return SELECTED_model(
        BrdfInput(s.normal, s.view, l, s.baseColor, s.metallic, s.perceptualRoughness, alpha, s.ior, lobe));
}

// What one light adds: f(v, l) * irradiance, `irradiance` of a surface that faces the light.
vec3 reflected(Surface s, float alpha, LobeAlbedo lobe, vec3 l, vec3 irradiance)
{
    BrdfTerms terms = reflectedTerms(s, alpha, lobe, l);
    return terms.brdf * irradiance * terms.weight;
}

#ifdef AREA_LIGHTS
#include "light/sphere.glsl"
#endif

vec3 punctualLight(Surface s, float alpha, LobeAlbedo lobe)
{
    vec3 sum = vec3(0.0);
    for (uint i = 0; i < kDirectionalCount; ++i)
        sum += reflected(s, alpha, lobe, lightDirection(i), lightIntensity(i));
    for (uint i = 0; i < kPointCount + kSpotCount; ++i)
    {
        Light light = lights[kDirectionalCount + i];
        vec3 toLight = light.position - s.position;
        float distance2 = dot(toLight, toLight);
        vec3 l = distance2 > 0.0 ? toLight * inversesqrt(distance2) : s.normal;
        float attenuation = distanceAttenuation(distance2, light.inverseRange);
        if (i >= kPointCount)
            attenuation *= coneAttenuation(dot(l, light.direction), light.coneScale, light.coneOffset);
#ifdef AREA_LIGHTS
        if (light.radius > 0.0)
        {
            float nearer = distance2 / max(distance2, light.radius * light.radius); // in the sphere: as from its surface
            sum += sphereLight(s, alpha, lobe, toLight, l, light.radius, light.intensity * (attenuation * nearer));
            continue;
        }
#endif
        sum += reflected(s, alpha, lobe, l, light.intensity * attenuation);
    }
    return sum;
}
#endif

vec3 shade(Surface s)
{
    float alpha = alphaOf(s);
#ifdef DFG_TABLE
    vec4 albedo = directionalAlbedo(clamp(dot(s.normal, s.view), 0.0, 1.0), s.perceptualRoughness);
    LobeAlbedo lobe = LobeAlbedo(albedo.w, albedo.y, 1.0, averageAlbedo(s.perceptualRoughness));
#else
    const vec4 albedo = vec4(1.0, 0.0, 0.0, 1.0); // no method reads it
    const LobeAlbedo lobe = LobeAlbedo(1.0, 0.0, 1.0, 1.0);
#endif
    vec3 lit = vec3(0.0);
#ifdef PUNCTUAL_LIGHTS
    lit = punctualLight(s, alpha, lobe);
#endif
#if defined(ENVIRONMENT_LIGHT) && defined(SELECTED_environment)
    return s.emissive + environmentLight(s, alpha, albedo, lit);
#elif defined(ENVIRONMENT_LIGHT)
    return s.emissive + lit + environmentLight(s, alpha, albedo);
#else
    return s.emissive + lit;
#endif
}

#endif
