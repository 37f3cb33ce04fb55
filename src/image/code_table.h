// A rising curve of [0, 1] to 8-bit codes, looked up: exact, and without a branch.
#pragma once

#include "math/float4.h"

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

    /// The table where a loop keeps it in registers: writing bytes could change any object but this one's copy.
    struct Lookup
    {
        std::uint32_t lowest;
        const std::uint32_t* cells;

        /// x in [0, 1].
        std::uint8_t operator()(float x) const
        {
            const std::uint32_t bits = std::max(std::bit_cast<std::uint32_t>(x), lowest);
            return static_cast<std::uint8_t>((cells[(bits - lowest) >> 16] + (bits & 0xffffu)) >> 16);
        }
        Int4 operator()(Float4 x) const
        {
            const auto floor = static_cast<int>(lowest);
            const auto bits = std::bit_cast<Int4>(greatest(x, splat(std::bit_cast<float>(lowest))));
            const Int4 cell = (bits - floor) >> 16;
            const auto at = [&](int i) { return static_cast<int>(cells[static_cast<std::size_t>(cell[i])]); };
            return (Int4{at(0), at(1), at(2), at(3)} + (bits & 0xffff)) >> 16;
        }
    };
    Lookup lookup() const { return {lowest, cells.data()}; }

private:
    std::uint32_t lowest; // where the first cell begins: below it the code is 0
    /// 65536 times the code at the cell's begin, and what the lower half of a float's bits lacks to the next one.
    std::vector<std::uint32_t> cells;
};

} // namespace torrance
