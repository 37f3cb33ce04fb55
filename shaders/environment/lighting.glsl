// Light from an environment: split sum (Karis 2013) for the lobe, irradiance for the body, both dimmed by occlusion.
#ifdef DFG_TABLE
#include "environment/average_albedo.glsl"
#ifdef DFG_FIT
#include "environment/diffuse_weight.glsl"

// (scale, bias, w, E) for a view direction and roughness, by the closed form that selected.glsl chose.
vec4 directionalAlbedo(float NoV, float perceptualRoughness)
{
    vec2 terms = DFG_FIT(NoV, perceptualRoughness);
    return vec4(terms, fittedDiffuseWeight(NoV), terms.x + terms.y);
}
#else
#include "environment/dfg.glsl"
layout(set = 0, binding = kBindDfg) uniform sampler2D dfgTable;

// (scale, bias, w, E) for a view direction and roughness: src/prepare/dfg_table.h.
vec4 directionalAlbedo(float NoV, float perceptualRoughness)
{
    return textureLod(dfgTable, dfgUv(NoV, perceptualRoughness, vec2(textureSize(dfgTable, 0))), 0.0);
}
#endif
#endif

#ifdef ENVIRONMENT_LIGHT
#include "environment/prefiltered.glsl"
layout(set = 0, binding = kBindEnvironmentSpecular) uniform samplerCube environmentSpecular;
#ifdef IRRADIANCE_SH9
#include "environment/irradiance_sh9.glsl"
#else
layout(set = 0, binding = kBindEnvironmentDiffuse) uniform samplerCube environmentDiffuse;
#endif

// Irradiance / pi of a surface with unit normal n, in the environment's axes.
vec3 irradianceOverPi(vec3 n)
{
#ifdef IRRADIANCE_SH9
    return irradianceSh9(frame.irradianceHarmonics, n);
#else
    return textureLod(environmentDiffuse, n, 0.0).rgb;
#endif
}

vec3 environmentLight(Surface s, float alpha, vec4 albedo)
{
    vec3 n = frame.environmentFromWorld * s.normal;
    vec3 r = frame.environmentFromWorld * reflect(-s.view, s.normal);
    vec3 radiance = prefilteredRadiance(environmentSpecular, r, alpha, frame.environmentLastLevel);
    vec3 irradiance = irradianceOverPi(n);
    // The lobes of glTF's dielectric and metal (shaders/brdf/model/gltf.glsl), each under an environment of radiance 1. Their light of many
    // reflections comes from everywhere: it is the irradiance's.
    const vec3 f0 = vec3(kDielectricF0);
    // The bias of a fit may be negative; a table's is not.
    vec3 once = max(f0 * albedo.x + albedo.y, 0.0);
    vec3 metalOnce = max(s.baseColor * albedo.x + albedo.y, 0.0);
    float mean = averageAlbedo(s.perceptualRoughness);
    vec3 dielectric = SELECTED_multiple_scattering(once * radiance, irradiance, f0, albedo.y, albedo.w, mean, mean);
    vec3 metal = SELECTED_multiple_scattering(metalOnce * radiance, irradiance, s.baseColor, albedo.y, albedo.w, mean, mean);
    vec3 specular = dielectric * (1.0 - s.metallic) + metal * s.metallic;

    // What the interface lets through: its weight is linear in what depends on the light, so the means over uniform light give the mean
    // weight. That of Schlick's term at VoH is the table's w, at NoL it is 1/21.
    vec3 returned = SELECTED_multiple_scattering(once, vec3(1.0), f0, albedo.y, albedo.w, mean, mean);
    float x = 1.0 - clamp(dot(s.normal, s.view), 0.0, 1.0);
    vec3 weight = SELECTED_diffuse_weight(f0 + (1.0 - f0) * albedo.z, f0 + (1.0 - f0) * (x * x * x * x * x), f0 + (1.0 - f0) / 21.0, returned);
    vec3 diffuse = irradiance * s.baseColor * ((1.0 - s.metallic) * weight);
    return (specular + diffuse) * (s.occlusion * frame.environmentIntensity);
}
#endif
