#include "shared/constants.h"

// Place of a direction in a lat-long picture: u = 0.5 + atan(z, x) / 2 pi, v = acos(y) / pi, top row +Y. At the poles, where
// atan(0, 0) is undefined, any u will do.
vec2 panoramaUv(vec3 d)
{
    float azimuth = d.x == 0.0 && d.z == 0.0 ? 0.0 : atan(d.z, d.x);
    float polar = atan(length(d.xz), d.y); // acos(y) that keeps its bits near the poles
    return vec2(0.5 + azimuth / (2.0 * PI), polar / PI);
}
