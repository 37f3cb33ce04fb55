#include "core/process_usage.h"

#include <cstring>
#include <gtest/gtest.h>
#include <memory>
#include <sys/mman.h>
#include <thread>
#include <vector>

namespace torrance {
namespace {

constexpr std::size_t kMebibyte = std::size_t(1) << 20;

void spin(double seconds)
{
    const double start = timeUse().wall;
    while (timeUse().wall - start < seconds) {
    }
}

// Two threads that work are on the processor at most twice as long as on the wall, and one that sleeps is not at all;
// how much of it a busy machine grants them is not ours to say.
TEST(TimeUse, CountsTheProcessorTimeOfAllThreads)
{
    const TimeUse start = timeUse();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const TimeUse slept = timeUse() - start;
    EXPECT_GE(slept.wall, 0.05);
    EXPECT_LT(slept.processor, 0.5 * slept.wall);

    timespec own = {};
    const TimeUse before = timeUse();
    std::jthread other([&] {
        spin(0.05);
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &own);
    });
    other.join();
    const TimeUse worked = timeUse() - before;
    EXPECT_GE(worked.processor, static_cast<double>(own.tv_sec) + 1e-9 * static_cast<double>(own.tv_nsec));
}

TEST(MemoryUse, GrowsWithPagesThatAreTouched)
{
    const MemoryUse before = memoryUse();
    ASSERT_GT(before.proportional, 0u) << "the kernel says nothing";
    constexpr std::size_t kBytes = 64 * kMebibyte;
    void* const pages = mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    ASSERT_NE(pages, MAP_FAILED);
    EXPECT_LT(memoryUse().own, before.own + kMebibyte) << "nothing is there before it is touched";
    std::memset(pages, 1, kBytes);
    const MemoryUse held = memoryUse();
    EXPECT_NEAR(static_cast<double>(held.own - before.own), double(kBytes), double(kMebibyte));
    EXPECT_GE(held.proportional, held.own);
    EXPECT_GE(peakResidentBytes(), kBytes);
    munmap(pages, kBytes);
    EXPECT_LT(memoryUse().own, before.own + kMebibyte);
}

TEST(MemoryUse, KnowsWhatIsAllocatedBesideWhatIsResident)
{
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer's allocator counts for itself";
#endif
    const MemoryUse before = memoryUse();
    constexpr std::size_t kPiece = 1000, kPieces = 10000;
    std::vector<std::unique_ptr<char[]>> pieces;
    pieces.reserve(kPieces);
    for (std::size_t i = 0; i < kPieces; ++i)
        pieces.push_back(std::make_unique<char[]>(kPiece));
    std::unique_ptr<char[]> untouched = std::make_unique_for_overwrite<char[]>(64 * kMebibyte); // mapped by itself
    [[maybe_unused]] const void* volatile seen = untouched.get(); // or the compiler leaves it out
    const MemoryUse held = memoryUse();
    EXPECT_NEAR(static_cast<double>(held.allocated - before.allocated), double(kPiece * kPieces + 64 * kMebibyte),
                double(kMebibyte));
    EXPECT_LT(held.own, before.own + kPiece * kPieces + 2 * kMebibyte);
    pieces.clear();
    untouched.reset();
    EXPECT_LT(memoryUse().allocated, before.allocated + kMebibyte);
}

TEST(MemorySampler, KeepsAPeakThatIsOver)
{
    const std::uint64_t before = memoryUse().proportional;
    MemorySampler sampler;
    constexpr std::size_t kBytes = 64 * kMebibyte;
    void* const pages = mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    ASSERT_NE(pages, MAP_FAILED);
    std::memset(pages, 1, kBytes);
    // As long as it takes: the sampler rests between its readings, and the machine may be busy.
    const auto seen = [&] { return sampler.seen() >= before + kBytes / 2; };
    for (int i = 0; i < 1000 && !seen(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    munmap(pages, kBytes);
    EXPECT_GE(sampler.peak(), before + kBytes / 2);
}

} // namespace
} // namespace torrance
