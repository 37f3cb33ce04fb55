// IEEE 754 binary16, as the device stores it.
#pragma once

#include <bit>
#include <cstdint>

namespace torrance {

/// The nearest half float, ties to even; beyond 65504 infinity, NaN stays NaN.
constexpr std::uint16_t toHalf(float value)
{
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const std::uint32_t sign = (bits >> 16) & 0x8000u;
    const std::uint32_t magnitude = bits & 0x7fffffffu;
    if (magnitude > 0x7f800000u)
        return static_cast<std::uint16_t>(sign | 0x7e00u);
    if (magnitude >= 0x477ff000u) // 65520, half way to what would follow 65504
        return static_cast<std::uint16_t>(sign | 0x7c00u);
    if (magnitude < 0x38800000u) // below 2^-14: subnormal, a multiple of 2^-24
    {
        const float shifted = std::bit_cast<float>(magnitude) + 0.5f; // 0.5 has a unit of 2^-24
        return static_cast<std::uint16_t>(sign | (std::bit_cast<std::uint32_t>(shifted) - 0x3f000000u));
    }
    const std::uint32_t rounded = magnitude + 0xfffu + ((magnitude >> 13) & 1u);
    return static_cast<std::uint16_t>(sign | ((rounded - 0x38000000u) >> 13));
}

} // namespace torrance
