// What the specular lobe reflects of an environment, by the method that selected.glsl chose.
#include "environment/specular_sums.glsl"

#if defined(SPECULAR_LAMPS)
#include "environment/lamp_specular.glsl"
layout(set = 0, binding = kBindEnvironmentLamps) uniform samplerCube environmentLamps;
#elif defined(SPECULAR_SAMPLER)
#include "environment/sampled_specular.glsl"
#elif defined(SPECULAR_EVEN)
#ifndef IRRADIANCE_EVEN
#include "environment/even.glsl"
#endif
#elif defined(SPECULAR_MIRROR)
#include "environment/mirror.glsl"
layout(set = 0, binding = kBindPanorama) uniform sampler2D panorama;
#else
#if defined(SPECULAR_PHONG_LEVELS)
#include "environment/phong_levels.glsl"
#elif defined(SPECULAR_GGX_LEVELS)
#include "environment/ggx_levels.glsl"
#else
#include "environment/prefiltered.glsl"
#endif
#ifdef SPECULAR_DOMINANT
#include "environment/dominant_direction.glsl"
#endif
layout(set = 0, binding = kBindEnvironmentSpecular) uniform samplerCube environmentSpecular;
#endif

#ifndef SPECULAR_SAMPLER
// The light about a direction in the environment's axes, not necessarily unit.
vec3 lightAbout(vec3 direction, float alpha)
{
#if defined(SPECULAR_EVEN)
    return evenRadiance(frame.irradianceHarmonics);
#elif defined(SPECULAR_MIRROR)
    return panoramaRadiance(panorama, direction);
#elif defined(SPECULAR_PHONG_LEVELS)
    return phongRadiance(environmentSpecular, direction, alpha);
#elif defined(SPECULAR_GGX_LEVELS)
    return ggxLevelRadiance(environmentSpecular, direction, alpha, QUIRK_five_levels ? 4.0 : 5.0);
#else
    return prefilteredRadiance(environmentSpecular, direction, alpha, frame.environmentLastLevel);
#endif
}
#endif

// n and v unit, in the environment's axes; `lamps` is what arrives of them; albedo is the lobe's (scale, bias, w, E) under light of radiance 1.
SpecularSums specularSums(vec3 n, vec3 v, float alpha, float perceptualRoughness, vec4 albedo, out LampIrradiance lamps)
{
    lamps = LampIrradiance(vec3(0.0), vec3(0.0), vec3(0.0));
#ifdef SPECULAR_SAMPLER
    vec2 rotation = pixelRotation(uvec2(gl_FragCoord.xy), frame.picture);
#ifdef SPECULAR_LAMPS
    return lampSums(environmentRadiance, environmentLamps, n, v, alpha, perceptualRoughness, rotation, lamps);
#else
    return sampledSums(environmentRadiance, n, v, alpha, perceptualRoughness, rotation);
#endif
#else
    vec3 direction = reflect(-v, n);
#ifdef SPECULAR_DOMINANT
    direction = dominantDirection(n, direction, alpha);
#endif
    vec3 light = lightAbout(direction, alpha);
    return SpecularSums(light * albedo.x, light * albedo.y);
#endif
}
