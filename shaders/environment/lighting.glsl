// Light from an environment: on the lobe and on the body, both dimmed by occlusion.
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
#ifdef READS_RADIANCE
layout(set = 0, binding = kBindEnvironmentRadiance) uniform samplerCube environmentRadiance; // not prefiltered, with mips
#endif
#include "environment/diffuse.glsl"
#include "environment/specular.glsl"

#ifdef SELECTED_environment
#include "environment/surroundings.glsl"

// All light, by the source's own model: of a lobe of scale 1 and bias 0 it takes the light itself.
vec3 environmentLight(Surface s, float alpha, vec4 albedo, vec3 lit)
{
    vec3 n = frame.environmentFromWorld * s.normal;
    vec3 v = frame.environmentFromWorld * s.view;
    float arriving = s.occlusion * frame.environmentIntensity;
    Surroundings around;
    LampIrradiance lamps; // no source's method has any
    around.mirrored = arriving * specularSums(n, v, alpha, s.perceptualRoughness, vec4(1.0, 0.0, 0.0, 1.0), lamps).scale;
#ifdef SPECULAR_MIRROR
    around.refracted = arriving * lightAbout(refractedDirection(n, v), alpha);
#else
    around.refracted = vec3(0.0);
#endif
    around.irradianceOverPi = arriving * irradianceOverPi(n);
    around.integrals = albedo.xyz;
    around.lit = lit;
    return SELECTED_environment(s.baseColor, s.metallic, clamp(dot(s.normal, s.view), 0.0, 1.0), around);
}
#else
#include "material/dielectric_f0.glsl"

vec3 environmentLight(Surface s, float alpha, vec4 albedo)
{
    vec3 n = frame.environmentFromWorld * s.normal;
    LampIrradiance lamps;
    SpecularSums sums = specularSums(n, frame.environmentFromWorld * s.view, alpha, s.perceptualRoughness, albedo, lamps);
    vec3 irradiance = irradianceOverPi(n);
    // What the lobes of glTF's dielectric and metal (shaders/brdf/model/gltf.glsl) reflect once. Their light of many reflections comes from
    // everywhere: it is the irradiance's. The bias of a fit may be negative; a table's is not.
    vec3 f0 = vec3(dielectricF0(s.ior));
    vec3 once = max(f0 * sums.scale + sums.bias, 0.0);
    vec3 metalOnce = max(s.baseColor * sums.scale + sums.bias, 0.0);
    float mean = averageAlbedo(s.perceptualRoughness);
    vec3 dielectric = SELECTED_multiple_scattering(once, irradiance, f0, albedo.y, albedo.w, mean, mean);
    vec3 metal = SELECTED_multiple_scattering(metalOnce, irradiance, s.baseColor, albedo.y, albedo.w, mean, mean);
    vec3 specular = dielectric * (1.0 - s.metallic) + metal * s.metallic;

    // What the interface lets through: its weight is linear in what depends on the light, so the means over the light give the mean
    // weight. Over uniform light that of Schlick's term at VoH is the table's w, at NoL it is 1/21. Of lamps the points know better.
    vec3 returned = SELECTED_multiple_scattering(max(f0 * albedo.x + albedo.y, 0.0), vec3(1.0), f0, albedo.y, albedo.w, mean, mean);
    float x = 1.0 - clamp(dot(s.normal, s.view), 0.0, 1.0);
    vec3 atVoH = vec3(albedo.z), atNoL = vec3(1.0 / 21.0);
#ifdef SPECULAR_LAMPS
    vec3 rest = irradiance - lamps.whole;
    vec3 all = max(irradiance, kLeastDenominator);
    atVoH = (rest * atVoH + lamps.atVoH) / all;
    atNoL = (rest * atNoL + lamps.atNoL) / all;
#endif
    vec3 weight = SELECTED_diffuse_weight(f0 + (1.0 - f0) * atVoH, f0 + (1.0 - f0) * fifthPower(x), f0 + (1.0 - f0) * atNoL, returned);
    vec3 diffuse = irradiance * s.baseColor * ((1.0 - s.metallic) * weight);
    return (specular + diffuse) * (s.occlusion * frame.environmentIntensity);
}
#endif
#endif
