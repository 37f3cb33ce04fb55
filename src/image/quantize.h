// From float to the code values of a file and back.
#pragma once

#include <cstdint>

namespace torrance {

/// Round-half-even of value * maximum, for value clipped to [0, 1]; NaN gives 0. `maximum` is 255 or 65535. The product
/// is formed in double, so that no code's boundary moves; adding 1.5 * 2^52 leaves a double no bits below one, without
/// the call that std::nearbyint is.
inline std::uint16_t quantized(float value, std::uint16_t maximum)
{
    constexpr double kNoFraction = 0x1.8p52;
    const double clipped = value > 0.0f ? (value < 1.0f ? static_cast<double>(value) : 1.0) : 0.0;
    return static_cast<std::uint16_t>(clipped * maximum + kNoFraction - kNoFraction);
}

/// The value that a code stands for.
inline float dequantized(std::uint16_t code, std::uint16_t maximum)
{
    return static_cast<float>(static_cast<double>(code) / maximum);
}

} // namespace torrance
