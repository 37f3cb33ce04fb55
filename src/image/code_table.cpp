#include "image/code_table.h"

#include <cassert>

namespace torrance {
namespace {

constexpr std::uint32_t kCellBits = 0x10000u;

std::uint32_t bitsOf(float x)
{
    return std::bit_cast<std::uint32_t>(x);
}

} // namespace

CodeTable::CodeTable(const CodeSteps& from) : lowest(bitsOf(from.front()) / kCellBits * kCellBits)
{
    assert(from.front() > 0.0f && from.back() <= 1.0f);
    std::uint32_t code = 0;
    for (std::uint32_t begin = lowest; begin <= bitsOf(1.0f); begin += kCellBits) {
        const bool rises = code < from.size() && bitsOf(from[code]) < begin + kCellBits;
        cells.push_back(code * kCellBits + (rises ? begin + kCellBits - bitsOf(from[code]) : 0));
        code += rises ? 1 : 0;
        assert(code == from.size() || bitsOf(from[code]) >= begin + kCellBits); // two steps in one cell
    }
    assert(code == from.size());
}

} // namespace torrance
