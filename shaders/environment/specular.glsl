// What the specular lobe reflects of an environment, by the method that selected.glsl chose.

// A lobe of reflectance F0 (Schlick's, of F90 = 1) reflects F0 scale + bias.
struct SpecularSums
{
    vec3 scale;
    vec3 bias;
};

#ifdef SPECULAR_SAMPLER
#include "environment/sampled_specular.glsl"
#else
#ifdef SPECULAR_PHONG_LEVELS
#include "environment/phong_levels.glsl"
#else
#include "environment/prefiltered.glsl"
#endif
#ifdef SPECULAR_DOMINANT
#include "environment/dominant_direction.glsl"
#endif
layout(set = 0, binding = kBindEnvironmentSpecular) uniform samplerCube environmentSpecular;
#endif

// n and v unit, in the environment's axes; albedo is the lobe's (scale, bias, w, E) under light of radiance 1.
SpecularSums specularSums(vec3 n, vec3 v, float alpha, float perceptualRoughness, vec4 albedo)
{
#ifdef SPECULAR_SAMPLER
    vec2 rotation = pixelRotation(uvec2(gl_FragCoord.xy), frame.picture);
    return sampledSums(environmentRadiance, n, v, alpha, perceptualRoughness, rotation);
#else
    vec3 direction = reflect(-v, n);
#ifdef SPECULAR_DOMINANT
    direction = dominantDirection(n, direction, alpha);
#endif
#ifdef SPECULAR_PHONG_LEVELS
    vec3 light = phongRadiance(environmentSpecular, direction, alpha);
#else
    vec3 light = prefilteredRadiance(environmentSpecular, direction, alpha, frame.environmentLastLevel);
#endif
    return SpecularSums(light * albedo.x, light * albedo.y);
#endif
}
