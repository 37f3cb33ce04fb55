// Points that fill the unit square more evenly than random ones, the same on every run.
#pragma once

#include "math/vector.h"

#include <cstdint>

namespace torrance {

/// The bits of x in reverse order.
constexpr std::uint32_t mirrorBits(std::uint32_t x)
{
    x = (x << 16) | (x >> 16);
    x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
    x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
    return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
}

/// Van der Corput sequence in base 2: the bits of `i` mirrored at the binary point; in [0, 1), exact.
inline double radicalInverse2(std::uint32_t i)
{
    return static_cast<double>(mirrorBits(i)) * 0x1p-32;
}

/// Point i of the Hammersley set of `count` points (Niederreiter 1992, section 3.1). The first coordinate stands in the
/// middle of its stratum, so that no point lies on the left edge of the square.
inline dvec2 hammersley(std::uint32_t i, std::uint32_t count)
{
    return {(static_cast<double>(i) + 0.5) / static_cast<double>(count), radicalInverse2(i)};
}

} // namespace torrance
