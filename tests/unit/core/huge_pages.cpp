#include "core/huge_pages.h"

#include <gtest/gtest.h>
#include <memory>
#include <numeric>

namespace torrance {
namespace {

// Whether the pages are large is for the system to say; what is in the block is not.
TEST(HugePages, KeepWhatIsInTheBlock)
{
    std::vector<int> numbers(5u << 20); // 20 MiB, wherever it begins
    std::iota(numbers.begin(), numbers.end(), 0);
    const std::vector<int> before = numbers;
    for (const std::size_t offset : {0u, 1u, 1023u, 600000u})
        preferHugePages(numbers.data() + offset, (numbers.size() - offset) * sizeof(int));
    preferHugePages(numbers.data(), 100); // not one whole page
    EXPECT_TRUE(numbers == before);
}

TEST(HugePages, ResizeLikeAVectorDoes)
{
    std::vector<int> items = {1, 2, 3};
    resizeLarge(items, 3u << 20);
    EXPECT_EQ(items.size(), 3u << 20);
    EXPECT_EQ(items[2], 3);
    EXPECT_EQ(std::count(items.begin() + 3, items.end(), 0), (3 << 20) - 3);
    resizeLarge(items, 2);
    EXPECT_EQ(items, (std::vector{1, 2}));
}

} // namespace
} // namespace torrance
