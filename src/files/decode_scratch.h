// Memory that decoders need while they work, kept from one picture to the next: the first touch of fresh pages costs as
// much as a third of decoding.
#pragma once

#include "core/huge_pages.h"

#include <cstddef>
#include <memory>

namespace torrance {

/// Grows and never shrinks; what is in it is whatever the last user left.
class ReusedBytes
{
public:
    std::byte* atLeast(std::size_t size)
    {
        if (size > capacity) {
            bytes.reset(); // before the new ones are taken
            bytes = std::make_unique_for_overwrite<std::byte[]>(size);
            preferHugePages(bytes.get(), size);
            capacity = size;
        }
        return bytes.get();
    }

private:
    std::unique_ptr<std::byte[]> bytes;
    std::size_t capacity = 0;
};

struct DecodeScratch
{
    ReusedBytes compressed;
    ReusedBytes filtered;
};

} // namespace torrance
