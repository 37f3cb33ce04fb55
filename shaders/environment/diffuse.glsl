// Irradiance of an environment, by the method that selected.glsl chose.
#if defined(IRRADIANCE_SH9)
#include "environment/irradiance_sh9.glsl"
#elif defined(IRRADIANCE_SH4)
#include "environment/irradiance_sh4.glsl"
#elif defined(IRRADIANCE_EVEN)
#include "environment/even.glsl"
#elif defined(IRRADIANCE_SAMPLED)
#include "environment/irradiance_sampled.glsl"
#elif !defined(IRRADIANCE_NONE)
layout(set = 0, binding = kBindEnvironmentDiffuse) uniform samplerCube environmentDiffuse;
#endif

// Irradiance / pi of a surface with unit normal n, in the environment's axes.
vec3 irradianceOverPi(vec3 n)
{
#if defined(IRRADIANCE_SH9)
    return irradianceSh9(frame.irradianceHarmonics, n);
#elif defined(IRRADIANCE_SH4)
    return irradianceSh4(frame.irradianceHarmonics, n);
#elif defined(IRRADIANCE_EVEN)
    return evenRadiance(frame.irradianceHarmonics);
#elif defined(IRRADIANCE_SAMPLED)
    return irradianceSampled(environmentRadiance, n);
#elif defined(IRRADIANCE_NONE)
    return vec3(0.0);
#else
    return textureLod(environmentDiffuse, n, 0.0).rgb;
#endif
}
