#include "core/disk_cache.h"

#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace torrance {
namespace {

namespace fs = std::filesystem;

class DiskCacheTest : public testing::Test
{
protected:
    DiskCacheTest() : folder(fs::temp_directory_path() / ("torrance-cache-" + std::to_string(getpid()))) {}
    ~DiskCacheTest() override { fs::remove_all(folder); }

    static std::vector<std::byte> bytes(std::size_t count, int value)
    {
        return std::vector<std::byte>(count, std::byte(value));
    }
    std::size_t entries() const
    {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }

    fs::path folder;
};

TEST_F(DiskCacheTest, GivesBackWhatWasStored)
{
    DiskCache cache(folder, 1 << 20);
    EXPECT_FALSE(cache.load(hashText("a")));
    cache.store(hashText("a"), bytes(100, 7));
    EXPECT_EQ(cache.load(hashText("a")), bytes(100, 7));
    EXPECT_FALSE(cache.load(hashText("b")));
    EXPECT_EQ(DiskCache(folder, 1 << 20).load(hashText("a")), bytes(100, 7)) << "it outlives the object";
}

TEST_F(DiskCacheTest, ADamagedEntryIsAMiss)
{
    DiskCache cache(folder, 1 << 20);
    cache.store(hashText("a"), bytes(100, 7));
    const fs::path file = folder / hashText("a").hex();
    for (const std::uintmax_t size : {std::uintmax_t(60), std::uintmax_t(3), std::uintmax_t(0)}) {
        fs::resize_file(file, size);
        EXPECT_FALSE(cache.load(hashText("a"))) << size;
    }
    cache.store(hashText("a"), bytes(100, 7));
    std::fstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(50).put('!');
    EXPECT_FALSE(cache.load(hashText("a"))) << "one byte was changed";
}

TEST_F(DiskCacheTest, StaysBelowItsBound)
{
    DiskCache cache(folder, 1000);
    for (int i = 0; i < 20; ++i)
        cache.store(hashText(std::to_string(i)), bytes(200, i));
    EXPECT_LE(entries(), 4u) << "four entries of 224 bytes fit in 1000";
    EXPECT_GE(entries(), 1u);
    EXPECT_TRUE(cache.load(hashText("19"))) << "the newest stays";
    cache.store(hashText("large"), bytes(2000, 1));
    EXPECT_FALSE(cache.load(hashText("large")));
}

TEST_F(DiskCacheTest, AFolderThatCannotBeMadeSwitchesItOff)
{
    std::ofstream(folder).put('x'); // a file where the folder should be
    DiskCache cache(folder / "below", 1 << 20);
    EXPECT_NO_THROW(cache.store(hashText("a"), bytes(10, 1)));
    EXPECT_FALSE(cache.load(hashText("a")));
}

TEST_F(DiskCacheTest, NoFolderIsNoCache)
{
    DiskCache cache({}, 1 << 20);
    cache.store(hashText("a"), bytes(10, 1));
    EXPECT_FALSE(cache.load(hashText("a")));
}

} // namespace
} // namespace torrance
