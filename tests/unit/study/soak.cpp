#include "study/soak.h"

#include <cstring>
#include <gtest/gtest.h>
#include <sys/mman.h>

namespace torrance {
namespace {

std::vector<MemoryUse> readings(int count, const std::function<double(int)>& bytes)
{
    std::vector<MemoryUse> all;
    for (int i = 0; i < count; ++i)
        all.push_back({.proportional = 0, .own = static_cast<std::uint64_t>(bytes(i)), .allocated = 0});
    return all;
}

TEST(JudgeSoak, LooksAtWhatGrowsAfterTheWarmUp)
{
    // Ten times the memory in the first hundred, then nothing.
    EXPECT_TRUE(judgeSoak(readings(300, [](int i) { return i < 90 ? 1e6 * (1 + i / 10) : 1e7; })).passed());
    // A leak of 1e4 bytes a render from 1e8: reading 95.5 stands for the 100th, 995.5 for the last. 9e6 / (1e8
    // + 95.5e4).
    const SoakVerdict leak = judgeSoak(readings(1000, [](int i) { return 1e8 + 1e4 * (i + 1); }));
    EXPECT_NEAR(leak.growth, 9e6 / (1e8 + 95.5e4), 1e-9);
    EXPECT_FALSE(leak.passed());
    // The same leak is not seen in 200 renders: 1e6 of 1e8.
    EXPECT_TRUE(judgeSoak(readings(200, [](int i) { return 1e8 + 1e4 * i; })).passed());
}

// 1e8 bytes are resident all the time, and more and more of them are in use.
TEST(JudgeSoak, SeesALeakIntoWhatWasFreed)
{
    std::vector<MemoryUse> use = readings(200, [](int) { return 1e8; });
    for (std::size_t i = 0; i < use.size(); ++i)
        use[i].allocated = 20000000 + 30000 * i;
    EXPECT_NEAR(judgeSoak(use).growth, 0.03, 1e-9);
    EXPECT_FALSE(judgeSoak(use).passed());
}

TEST(JudgeSoak, IsNotFooledByOneReading)
{
    EXPECT_TRUE(judgeSoak(readings(200, [](int i) { return i == 199 ? 2e8 : 1e8; })).passed());
    EXPECT_TRUE(judgeSoak(readings(200, [](int i) { return i == 99 ? 1.0 : 1e8; })).passed());
}

TEST(Soak, SeesWhatIsKept)
{
    constexpr std::size_t kBytes = std::size_t(1) << 20;
    std::vector<void*> kept; // from the system, not from what earlier tests have given back to the heap
    const std::vector<MemoryUse> use = soak(kSoakWarmUp + kSoakWindow + 1, [&](int) {
        kept.push_back(mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
        ASSERT_NE(kept.back(), MAP_FAILED);
        std::memset(kept.back(), 1, kBytes);
    });
    EXPECT_NEAR(static_cast<double>(use.back().own - use.front().own), double(kBytes * (use.size() - 1)),
                double(kBytes));
    EXPECT_FALSE(judgeSoak(use).passed());
    for (void* const pages : kept)
        munmap(pages, kBytes);
}

} // namespace
} // namespace torrance
