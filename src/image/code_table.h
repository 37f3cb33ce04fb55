// A rising curve of [0, 1] to 8-bit codes, looked up: exact, and without a branch.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace torrance {

/// The numbers at which the code rises: from[c] is the least float of [0, 1] whose code is c + 1 or more.
using CodeSteps = std::array<float, 255>;

/// Floats of one sign are ordered as their bits are, so that all floats with the same leading 16 bits are a piece of
/// the axis: so short that the code rises at most once within it.
class CodeTable
{
public:
    explicit CodeTable(const CodeSteps& from);

    /// x in [0, 1].
    std::uint8_t operator()(float x) const
    {
        const std::uint32_t bits = std::max(std::bit_cast<std::uint32_t>(x), lowest);
        return static_cast<std::uint8_t>((cells[(bits - lowest) >> 16] + (bits & 0xffffu)) >> 16);
    }

private:
    std::uint32_t lowest; // where the first cell begins: below it the code is 0
    /// 65536 times the code at the cell's begin, and what the lower half of a float's bits lacks to the next one.
    std::vector<std::uint32_t> cells;
};

} // namespace torrance
