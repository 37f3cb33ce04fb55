// From float to the code values of a file and back.
#pragma once

#include <cmath>
#include <cstdint>

namespace torrance {

/// Round-half-even of value * maximum, for value clipped to [0, 1]; NaN gives 0. `maximum` is 255 or 65535. The
/// rounding is that of std::nearbyint in the default mode; the product is formed in double, so that no code's boundary
/// moves.
inline std::uint16_t quantized(float value, std::uint16_t maximum)
{
    const double clipped = value > 0.0f ? (value < 1.0f ? static_cast<double>(value) : 1.0) : 0.0;
    return static_cast<std::uint16_t>(std::nearbyint(clipped * maximum));
}

/// The value that a code stands for.
inline float dequantized(std::uint16_t code, std::uint16_t maximum)
{
    return static_cast<float>(static_cast<double>(code) / maximum);
}

} // namespace torrance
