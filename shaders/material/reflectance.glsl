// The selected Fresnel term for a material that gives a reflectance f0 and no index.
#include "shared/constants.h"

vec3 reflectance(float cosine, float oneLessCosine, vec3 f0)
{
    return SELECTED_fresnel(cosine, oneLessCosine, f0, vec3(1.0), kDielectricIor, vec3(kDielectricIor), vec3(0.0), vec3(1.0));
}
