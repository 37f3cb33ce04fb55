#include "image/srgb.h"

#include <cmath>

namespace torrance {
namespace {

// The standard prints both limits rounded; the segments meet at them to 1e-7 only, far below a 16-bit step.
constexpr double kLinearLimit = 0.0031308;
constexpr double kEncodedLimit = 0.04045;

template <typename T>
T encode(T x)
{
    if (!(x > T(0)))
        return T(0);
    return x <= T(kLinearLimit) ? T(12.92) * x : T(1.055) * std::pow(x, T(1.0 / 2.4)) - T(0.055);
}

template <typename T>
T decode(T x)
{
    if (!(x > T(0)))
        return T(0);
    return x <= T(kEncodedLimit) ? x / T(12.92) : std::pow((x + T(0.055)) / T(1.055), T(2.4));
}

} // namespace

double srgbEncode(double linear)
{
    return encode(linear);
}

float srgbEncode(float linear)
{
    return encode(linear);
}

double srgbDecode(double encoded)
{
    return decode(encoded);
}

float srgbDecode(float encoded)
{
    return decode(encoded);
}

dvec3 transfer_srgb(const dvec3& linear)
{
    return {encode(linear.x), encode(linear.y), encode(linear.z)};
}

} // namespace torrance
