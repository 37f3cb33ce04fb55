// As many independent random numbers as somebody needs, from one key.
#pragma once

#include <cstdint>

namespace torrance {

/// SplitMix64 (Steele, Lea & Flood, Fast Splittable Pseudorandom Number Generators, 2014).
class NumberStream
{
public:
    explicit NumberStream(std::uint64_t key) : state(key) {}

    /// In the open interval (0, 1).
    double next()
    {
        std::uint64_t z = state += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return (static_cast<double>((z ^ (z >> 31)) >> 12) + 0.5) * 0x1p-52;
    }

private:
    std::uint64_t state;
};

} // namespace torrance
