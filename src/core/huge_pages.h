// Large blocks in large pages: the first touch of a page costs the same whether it is of 4 KiB or of 2 MiB, and
// pictures are thousands of small ones.
#pragma once

#include <cstddef>
#include <vector>

namespace torrance {

/// Asks for pages of 2 MiB for what lies whole within a block, before it is first written. What is in the block stays;
/// where the system does not grant it, nothing changes.
void preferHugePages(void* block, std::size_t bytes);

/// items.resize(count) where new memory is taken for many.
template <typename T>
void resizeLarge(std::vector<T>& items, std::size_t count)
{
    if (count > items.capacity()) {
        items.reserve(count);
        preferHugePages(items.data() + items.size(), (count - items.size()) * sizeof(T));
    }
    items.resize(count);
}

} // namespace torrance
