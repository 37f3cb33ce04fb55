// Sums of absolute values: how far colours lie apart, and what that is held against.
#pragma once

#include "math/vector.h"

#include <cmath>

namespace torrance {

inline double norm1(const dvec3& v)
{
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// Of the first channels of a texel.
inline double norm1(const float* texel, int channels)
{
    double sum = 0.0;
    for (int channel = 0; channel < channels; ++channel)
        sum += std::abs(double(texel[channel]));
    return sum;
}

/// Of the difference of two.
inline double distance1(const float* a, const float* b, int channels)
{
    double sum = 0.0;
    for (int channel = 0; channel < channels; ++channel)
        sum += std::abs(double(a[channel]) - double(b[channel]));
    return sum;
}

} // namespace torrance
