// Source B, third rung, under an environment: L (F x + y) by its integration map, whose x and y hold Schlick's rise already, so that F is
// f0. The body is the irradiance / pi under the map's z.
#include "environment/surroundings.glsl"
#include "material/model_parts.glsl"

vec3 environment_ggx_burley(vec3 base, float metallic, float NoV, Surroundings around)
{
    const float kF0 = 0.5; // the source's dielectric
    Fresnel atView = schlickMix(kF0, base, metallic, NoV, 1.0 - NoV);
    vec3 F = QUIRK_fresnel_at_view ? atView.reflected : atView.f0;
    vec3 lobe = F * around.integrals.x + around.integrals.y;
    vec3 body = base * ((1.0 - metallic) * around.integrals.z);
    return around.lit + lobe * around.mirrored + body * around.irradianceOverPi;
}
