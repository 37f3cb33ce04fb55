// Points of the unit square that are random, even, and a pure function of a key and their number: no state, no order.
#pragma once

#include "math/low_discrepancy.h"

#include <cstdint>
#include <initializer_list>

namespace torrance {

/// A 64-bit hash of numbers in their order (the finaliser of SplitMix64, Steele, Lea & Flood 2014, after each).
inline std::uint64_t hashNumbers(std::initializer_list<std::uint64_t> numbers)
{
    std::uint64_t hash = 0;
    for (const std::uint64_t number : numbers) {
        hash += number + 0x9e3779b97f4a7c15u;
        hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
        hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
        hash ^= hash >> 31;
    }
    return hash;
}

/// The first two dimensions of Sobol' (1967), scrambled by a hash in place of Owen's tree of random swaps: Laine &
/// Karras 2011 with the constants of Burley, Practical Hash-based Owen Scrambling, 2020, listing 1. Every step after
/// the addition of the seed is one-to-one and knows no seed; so each point by itself is even over the 2^32 x 2^32 cells
/// of the square when the seeds are, and a mean over points has no bias. Sequences of different keys are independent.
class ScrambledSequence
{
public:
    explicit ScrambledSequence(std::uint64_t key)
        : seedX(static_cast<std::uint32_t>(key)), seedY(static_cast<std::uint32_t>(key >> 32))
    {
    }

    /// Point i, in the open square: the middle of its cell.
    dvec2 operator[](std::uint32_t i) const
    {
        // Dimension one is i mirrored, and the scrambling works on mirrored numbers: i itself.
        return {unit(scrambled(i, seedX)), unit(scrambled(mirroredSecondDimension(i), seedY))};
    }

private:
    static double unit(std::uint32_t mirrored) { return (static_cast<double>(mirrorBits(mirrored)) + 0.5) * 0x1p-32; }

    static std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed)
    {
        x += seed;
        x ^= x * 0x6c50b47cu;
        x ^= x * 0xb82f1e52u;
        x ^= x * 0xc7afe638u;
        x ^= x * 0x8d22f6e6u;
        return x;
    }

    /// Direction numbers of the primitive polynomial x + 1: column k of Pascal's triangle modulo 2, mirrored.
    static std::uint32_t mirroredSecondDimension(std::uint32_t i)
    {
        std::uint32_t result = 0;
        for (std::uint32_t column = 1; i != 0; i >>= 1, column ^= column << 1)
            if (i & 1u)
                result ^= column;
        return result;
    }

    std::uint32_t seedX, seedY;
};

} // namespace torrance
