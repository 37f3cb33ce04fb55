// Four floats at a time, in the compiler's vector type: SSE2 on every x86-64 processor. Each lane has the bits that the
// scalar operation gives.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace torrance {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = int __attribute__((vector_size(16)));

inline Float4 splat(float value)
{
    return Float4{value, value, value, value};
}

/// As std::min and std::max: the first where neither is less, so that of a NaN and a number the first one stays.
inline Float4 least(Float4 a, Float4 b)
{
#ifdef __SSE2__
    return _mm_min_ps(b, a);
#else
    return b < a ? b : a;
#endif
}

inline Float4 greatest(Float4 a, Float4 b)
{
#ifdef __SSE2__
    return _mm_max_ps(b, a);
#else
    return a < b ? b : a;
#endif
}

// The same of one number, for formulas that are written for both.

template <typename T>
requires std::is_floating_point_v<T> T least(T a, T b)
{
    return std::min(a, b);
}

template <typename T>
requires std::is_floating_point_v<T> T greatest(T a, T b)
{
    return std::max(a, b);
}

inline bool all(bool holds)
{
    return holds;
}

/// Whether all lanes of a comparison hold.
inline bool all(Int4 mask)
{
#ifdef __SSE2__
    return _mm_movemask_epi8(__m128i(mask)) == 0xffff;
#else
    return (mask[0] & mask[1] & mask[2] & mask[3]) != 0;
#endif
}

inline Float4 load4(const float* from)
{
    return Float4{from[0], from[1], from[2], from[3]};
}

inline Float4 squareRoot(Float4 a)
{
#ifdef __SSE2__
    return _mm_sqrt_ps(a);
#else
    return Float4{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}

/// quantized() of each lane, for values in [0, 1] and a maximum of at most 65535.
inline Int4 roundedProduct(Float4 value, double maximum)
{
#ifdef __SSE2__
    const auto half = [&](__m128 two) { return _mm_cvtpd_epi32(_mm_cvtps_pd(two) * _mm_set1_pd(maximum)); };
    return Int4(_mm_unpacklo_epi64(half(value), half(_mm_movehl_ps(value, value))));
#else
    using Double4 = double __attribute__((vector_size(32)));
    constexpr double kNoFraction = 0x1.8p52;
    const Double4 product = __builtin_convertvector(value, Double4) * maximum;
    return __builtin_convertvector(product + kNoFraction - kNoFraction, Int4);
#endif
}

/// Rows to columns and back: lane i of the j-th becomes lane j of the i-th.
inline void transpose(Float4& a, Float4& b, Float4& c, Float4& d)
{
#ifdef __SSE2__
    const Float4 ab02 = _mm_unpacklo_ps(a, b), ab13 = _mm_unpackhi_ps(a, b);
    const Float4 cd02 = _mm_unpacklo_ps(c, d), cd13 = _mm_unpackhi_ps(c, d);
    a = _mm_movelh_ps(ab02, cd02);
    b = _mm_movehl_ps(cd02, ab02);
    c = _mm_movelh_ps(ab13, cd13);
    d = _mm_movehl_ps(cd13, ab13);
#else
    const Float4 ra = a, rb = b, rc = c, rd = d;
    a = Float4{ra[0], rb[0], rc[0], rd[0]};
    b = Float4{ra[1], rb[1], rc[1], rd[1]};
    c = Float4{ra[2], rb[2], rc[2], rd[2]};
    d = Float4{ra[3], rb[3], rc[3], rd[3]};
#endif
}

inline void transpose(Int4& a, Int4& b, Int4& c, Int4& d)
{
    Float4 rows[] = {Float4(a), Float4(b), Float4(c), Float4(d)}; // bits, not numbers
    transpose(rows[0], rows[1], rows[2], rows[3]);
    a = Int4(rows[0]);
    b = Int4(rows[1]);
    c = Int4(rows[2]);
    d = Int4(rows[3]);
}

/// The lanes of all four in turn, as numbers of 8 or 16 bits, which they fit into.
inline void pack(Int4 a, Int4 b, Int4 c, Int4 d, std::uint8_t* to)
{
#ifdef __SSE2__
    const __m128i ab = _mm_packs_epi32(__m128i(a), __m128i(b)), cd = _mm_packs_epi32(__m128i(c), __m128i(d));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm_packus_epi16(ab, cd));
#else
    for (int i = 0; i < 16; ++i)
        to[i] = static_cast<std::uint8_t>((i < 4 ? a : i < 8 ? b : i < 12 ? c : d)[i % 4]);
#endif
}

inline void pack(Int4 a, Int4 b, Int4 c, Int4 d, std::uint16_t* to)
{
#ifdef __SSE2__
    // SSE2 packs signed numbers only: [0, 65535] is moved to [-32768, 32767] and back.
    constexpr int kHalf = 32768;
    const __m128i back = _mm_set1_epi16(static_cast<short>(kHalf));
    const __m128i ab = _mm_packs_epi32(__m128i(a - kHalf), __m128i(b - kHalf));
    const __m128i cd = _mm_packs_epi32(__m128i(c - kHalf), __m128i(d - kHalf));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm_xor_si128(ab, back));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to + 8), _mm_xor_si128(cd, back));
#else
    for (int i = 0; i < 16; ++i)
        to[i] = static_cast<std::uint16_t>((i < 4 ? a : i < 8 ? b : i < 12 ? c : d)[i % 4]);
#endif
}

} // namespace torrance
