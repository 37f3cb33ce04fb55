// By how much a pixel's samples are moved against its neighbours', so that what they lack looks like grain and not like
// stripes.
#pragma once

#include "math/vector.h"

#include <cstdint>

namespace torrance {

/// Two fractions in [0, 1), multiples of 2^-24, of a pixel of picture number `picture` among those whose mean is the
/// result: PCG2D of Jarzynski & Olano, Hash Functions for GPU Rendering, 2020. Integers alone: shaders/environment/
/// sample_points.glsl gives the same to the bit.
inline dvec2 pixelRotation(std::uint32_t x, std::uint32_t y, std::uint32_t picture)
{
    constexpr std::uint32_t kFactor = 1664525u, kAddend = 1013904223u;
    constexpr std::uint32_t kHighestPicture = 32768u; // pixels: pictures follow each other without overlap
    std::uint32_t a = x * kFactor + kAddend;
    std::uint32_t b = (y + kHighestPicture * picture) * kFactor + kAddend;
    const auto mix = [&] {
        a += b * kFactor;
        b += a * kFactor;
    };
    const auto fold = [](std::uint32_t v) { return v ^ (v >> 16); };
    mix();
    a = fold(a), b = fold(b);
    mix();
    a = fold(a), b = fold(b);
    return {(a >> 8) * 0x1p-24, (b >> 8) * 0x1p-24};
}

/// p + rotation, modulo 1 in both coordinates (Cranley & Patterson 1976).
inline dvec2 rotatedPoint(const dvec2& p, const dvec2& rotation)
{
    return glm::fract(p + rotation);
}

} // namespace torrance
