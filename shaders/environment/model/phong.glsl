// Source B, first rung, in an environment: what the lights and the refracted map make of the surface, and over it the mirrored map by
// (1 - n.v)^exponent.
#include "environment/surroundings.glsl"
#include "material/model_parts.glsl"

vec3 environment_phong(vec3 base, float metallic, float NoV, Surroundings around)
{
    // pow(0, 0) is undefined; an exponent of 0 is a share that does not depend on the angle.
    float fresnel = PARAMETER_fresnel_exponent == 0.0 ? 1.0 : pow(1.0 - NoV, PARAMETER_fresnel_exponent);
    vec3 body = blended(around.lit, around.refracted, PARAMETER_refraction);
    return blended(body, around.mirrored, PARAMETER_reflection * fresnel);
}
