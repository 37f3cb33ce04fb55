// Source E under an environment: Li out of the mirror direction, the irradiance / pi of the body, F at h = n.
#include "environment/surroundings.glsl"
#include "material/model_parts.glsl"

vec3 environment_torrance_sparrow_blinn(vec3 color, float metalness, float NoV, Surroundings around)
{
    Fresnel F = schlickMix(kDielectricF0, vec3(1.0), metalness, NoV, 1.0 - NoV);
    vec3 lambert = color * around.irradianceOverPi;
    vec3 layer = F.reflected * around.mirrored;
    vec3 body = lambert * (1.0 - PARAMETER_reflectivity + PARAMETER_reflectivity * (1.0 - metalness) * F.transmitted);
    return around.lit + PARAMETER_reflectivity * blended(layer, layer * color, metalness) + body;
}
