// Points that fill the unit square more evenly than random ones, the same on every run.
#pragma once

#include "math/vector.h"

#include <cstdint>

namespace torrance {

/// Van der Corput sequence in base 2: the bits of `i` mirrored at the binary point; in [0, 1), exact.
inline double radicalInverse2(std::uint32_t i)
{
    i = (i << 16) | (i >> 16);
    i = ((i & 0x00ff00ffu) << 8) | ((i & 0xff00ff00u) >> 8);
    i = ((i & 0x0f0f0f0fu) << 4) | ((i & 0xf0f0f0f0u) >> 4);
    i = ((i & 0x33333333u) << 2) | ((i & 0xccccccccu) >> 2);
    i = ((i & 0x55555555u) << 1) | ((i & 0xaaaaaaaau) >> 1);
    return static_cast<double>(i) * 0x1p-32;
}

/// Point i of the Hammersley set of `count` points (Niederreiter 1992, section 3.1). The first coordinate stands in the
/// middle of its stratum, so that no point lies on the left edge of the square.
inline dvec2 hammersley(std::uint32_t i, std::uint32_t count)
{
    return {(static_cast<double>(i) + 0.5) / static_cast<double>(count), radicalInverse2(i)};
}

} // namespace torrance
