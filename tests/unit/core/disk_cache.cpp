#include "core/disk_cache.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/wait.h>
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
    cache.store(hashText("a"), bytes(100, 7));
    constexpr std::streamoff kSizeAt = 24;                        // behind the magic and the key
    const std::uint64_t wraps = fs::file_size(file) - kPageBytes; // a page more is the file's own length
    std::fstream(file, std::ios::in | std::ios::out | std::ios::binary)
        .seekp(kSizeAt)
        .write(reinterpret_cast<const char*>(&wraps), sizeof wraps);
    EXPECT_FALSE(openResult(file, hashText("a"))) << "a size beyond all files";
}

TEST_F(DiskCacheTest, ALargeEntryIsMappedUnlessItIsDamaged)
{
    constexpr std::size_t kLarge = 5000001; // several pieces, and no whole page at its end
    DiskCache cache(folder, 1 << 24);
    std::vector<std::byte> content = bytes(kLarge, 7);
    content.back() = std::byte(9);
    cache.store(hashText("a"), content);
    EXPECT_EQ(cache.load(hashText("a")), content) << "read as well as mapped";
    auto mapped = cache.open(hashText("a"))->map();
    ASSERT_TRUE(mapped);
    EXPECT_TRUE(std::ranges::equal(mapped->bytes(), content));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(mapped->bytes().data()) % kPageBytes, 0u);
    cache.store(hashText("small"), bytes(100, 7));
    EXPECT_FALSE(cache.open(hashText("small"))->map());
    const fs::path file = folder / hashText("a").hex();
    std::fstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(-1, std::ios::end).put('!');
    EXPECT_FALSE(cache.open(hashText("a"))->map()) << "one byte was changed";
}

TEST_F(DiskCacheTest, StaysBelowItsBound)
{
    DiskCache cache(folder, 1000);
    for (int i = 0; i < 20; ++i)
        cache.store(hashText(std::to_string(i)), bytes(200, i));
    EXPECT_LE(entries(), 4u) << "four entries of 248 bytes fit in 1000";
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

TEST_F(DiskCacheTest, AnEntryOfAnotherVersionIsAMissAndIsMadeAgain)
{
    DiskCache cache(folder, 1 << 20);
    cache.store(hashText("a"), bytes(100, 7));
    const fs::path file = folder / hashText("a").hex();
    std::fstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(7).put('1'); // the version's digit
    EXPECT_FALSE(cache.load(hashText("a")));
    cache.store(hashText("a"), bytes(100, 8));
    EXPECT_EQ(cache.load(hashText("a")), bytes(100, 8));
    fs::rename(file, folder / hashText("b").hex());
    EXPECT_FALSE(cache.load(hashText("b"))) << "another key's content";
}

// A process that is ended while it writes leaves a file under a name of its own, which the next one to write removes
// once nobody can be at work on it.
TEST_F(DiskCacheTest, WhatAKilledProcessLeftGoes)
{
    DiskCache cache(folder, 1 << 20);
    cache.store(hashText("a"), bytes(100, 7));
    const auto leave = [&](const char* number, std::chrono::hours age) {
        const fs::path file = folder / ("." + hashText("b").hex() + "." + number);
        std::ofstream(file) << "half";
        fs::last_write_time(file, fs::file_time_type::clock::now() - age);
        return file;
    };
    const fs::path old = leave("123-0", std::chrono::hours(2)), recent = leave("124-0", std::chrono::hours(0));
    EXPECT_FALSE(cache.load(hashText("b")));
    cache.store(hashText("c"), bytes(100, 7));
    EXPECT_FALSE(fs::exists(old));
    EXPECT_TRUE(fs::exists(recent));
    EXPECT_EQ(cache.load(hashText("a")), bytes(100, 7));
}

TEST_F(DiskCacheTest, WhatWasUsedLastStaysLongestAndOthersFilesStay)
{
    DiskCache cache(folder, 1000);
    cache.store(hashText("a"), bytes(300, 1));
    cache.store(hashText("b"), bytes(300, 2));
    std::ofstream(folder / "notes.txt") << std::string(5000, 'x');
    const auto ago = fs::file_time_type::clock::now();
    fs::last_write_time(folder / hashText("a").hex(), ago - std::chrono::hours(72));
    fs::last_write_time(folder / hashText("b").hex(), ago - std::chrono::hours(48));
    EXPECT_TRUE(cache.load(hashText("a"))) << "and counts as used now";
    cache.store(hashText("c"), bytes(300, 3));
    EXPECT_TRUE(cache.load(hashText("a")));
    EXPECT_FALSE(cache.load(hashText("b")));
    EXPECT_TRUE(fs::exists(folder / "notes.txt"));
}

// Processes that fill one folder at once, past its bound: whoever reads an entry gets all of it or none.
TEST_F(DiskCacheTest, SeveralProcessesFillItAtOnce)
{
    constexpr int kProcesses = 4, kRounds = 200, kKeys = 7;
    std::vector<pid_t> children;
    for (int process = 0; process < kProcesses; ++process) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child > 0) {
            children.push_back(child);
            continue;
        }
        DiskCache cache(folder, 20000);
        bool whole = true;
        for (int round = 0; round < kRounds; ++round) {
            const int key = (round * 3 + process) % kKeys;
            cache.store(hashText(std::to_string(key)), bytes(5000, key));
            const auto read = cache.load(hashText(std::to_string((key + 1) % kKeys)));
            whole = whole && (!read || *read == bytes(5000, (key + 1) % kKeys));
        }
        _exit(whole ? 0 : 1);
    }
    for (const pid_t child : children) {
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    }
    std::size_t found = 0;
    DiskCache cache(folder, 20000);
    for (int key = 0; key < kKeys; ++key)
        if (const auto read = cache.load(hashText(std::to_string(key)))) {
            EXPECT_EQ(*read, bytes(5000, key));
            ++found;
        }
    EXPECT_GE(found, 1u);
}

} // namespace
} // namespace torrance
