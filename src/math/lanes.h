// Eight floats at a time, by the vector types of the compiler. A function that works on them is compiled twice, for
// every x86-64 and for AVX2, and gives the same bytes either way: a lane's operations are those of one float, each
// rounded by itself.
#pragma once

#include <cstring>

// They are passed by value between functions that are inlined: no calling convention is involved.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace torrance {

inline constexpr int kLanes = 8;
using Lanes = float __attribute__((vector_size(kLanes * sizeof(float)), may_alias));
using IntLanes = int __attribute__((vector_size(kLanes * sizeof(int))));

#define TORRANCE_INLINE [[gnu::always_inline]] inline

#if defined(__x86_64__)
#define TORRANCE_AVX2 [[gnu::target("avx2")]]
inline bool processorHasAvx2()
{
    static const bool has = __builtin_cpu_supports("avx2");
    return has;
}
#else
#define TORRANCE_AVX2
inline bool processorHasAvx2()
{
    return false;
}
#endif

// By reference: how a vector is passed by value depends on the instruction set.
TORRANCE_INLINE void load(Lanes& lanes, const float* from)
{
    std::memcpy(&lanes, from, sizeof lanes);
}

TORRANCE_INLINE void store(float* to, const Lanes& lanes)
{
    std::memcpy(to, &lanes, sizeof lanes);
}

} // namespace torrance
