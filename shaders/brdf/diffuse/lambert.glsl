// Lambert 1760; glTF 2.0, Appendix B, diffuse_brdf.
#include "shared/constants.h"

vec3 Fd_lambert(float NoV, float NoL, float VoL, float NoH, float VoH, float alpha, float perceptualRoughness, vec3 baseColor)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return vec3(0.0);
    return baseColor / PI;
}
