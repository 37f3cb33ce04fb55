#include "core/huge_pages.h"

#include <cstdint>
#include <sys/mman.h>

namespace torrance {

void preferHugePages(void* block, std::size_t bytes)
{
#ifdef MADV_HUGEPAGE
    constexpr std::uintptr_t kPage = 1u << 21;
    const auto begin = reinterpret_cast<std::uintptr_t>(block);
    const std::uintptr_t first = (begin + kPage - 1) / kPage * kPage, end = (begin + bytes) / kPage * kPage;
    if (first < end)
        madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE); // a refusal is no harm
#else
    static_cast<void>(block);
    static_cast<void>(bytes);
#endif
}

} // namespace torrance
