// Light from an environment: split sum (Karis 2013) for the lobe, irradiance for the body, both dimmed by occlusion.
#ifdef DFG_TABLE
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
    // The lobes of glTF's dielectric and metal (shaders/brdf/model/gltf.glsl), each under an environment of radiance 1.
    const vec3 dielectricF0 = vec3(kDielectricF0);
    // The bias of a fit may be negative; a table's is not.
    vec3 dielectric = max(dielectricF0 * albedo.x + albedo.y, 0.0);
    vec3 metal = max(s.baseColor * albedo.x + albedo.y, 0.0);
#ifdef COMPENSATES
    dielectric *= SELECTED_multiple_scattering(dielectricF0, albedo.w);
    metal *= SELECTED_multiple_scattering(s.baseColor, albedo.w);
#endif
    vec3 lobe = dielectric * (1.0 - s.metallic) + metal * s.metallic;
    vec3 specular = prefilteredRadiance(environmentSpecular, r, alpha, frame.environmentLastLevel) * lobe;
    // What the dielectric interface lets through: (1 - F) averaged over the light directions, w = (1/pi) int (1-VoH)^5 NoL.
    vec3 body = s.baseColor * ((1.0 - s.metallic) * (1.0 - kDielectricF0) * (1.0 - albedo.z));
    vec3 diffuse = irradianceOverPi(n) * body;
    return (specular + diffuse) * (s.occlusion * frame.environmentIntensity);
}
#endif
