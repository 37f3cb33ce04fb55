// Source E under an environment: Li out of the mirror direction, the irradiance / pi of the body, F at h = n.
#include "material/model_parts.glsl"

vec3 environment_torrance_sparrow_blinn(vec3 color, float metalness, float NoV, vec3 Li, vec3 irradianceOverPi)
{
    Fresnel F = schlickMix(kDielectricF0, vec3(1.0), metalness, NoV, 1.0 - NoV);
    vec3 lambert = color * irradianceOverPi;
    vec3 layer = F.reflected * Li;
    vec3 body = lambert * (1.0 - PARAMETER_reflectivity + PARAMETER_reflectivity * (1.0 - metalness) * F.transmitted);
    return PARAMETER_reflectivity * blended(layer, layer * color, metalness) + body;
}
