// Four halves at a time.
#pragma once

#include "math/float4.h"

namespace torrance {

/// toHalf (math/half.h) of each lane, for values in [0, 1].
inline Int4 halfBits(Float4 value)
{
    const Int4 bits = Int4(value);
    const Int4 rounded = (bits + 0xfff + ((bits >> 13) & 1) - 0x38000000) >> 13;
    const Int4 subnormal = Int4(value + 0.5f) - 0x3f000000; // multiples of 2^-24, the unit of 0.5
    return bits < 0x38800000 ? subnormal : rounded;
}

} // namespace torrance
