#include "core/mapped_file.h"

#include <algorithm>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <unistd.h>

namespace torrance {
namespace {

namespace fs = std::filesystem;

class MappedFileTest : public testing::Test
{
protected:
    MappedFileTest() : path(fs::temp_directory_path() / ("torrance-mapped-" + std::to_string(getpid())))
    {
        std::string text(3 * kPageBytes, 'a');
        std::fill(text.begin() + kPageBytes, text.end(), 'b');
        std::ofstream(path) << text;
        descriptor = ::open(path.c_str(), O_RDONLY);
    }
    ~MappedFileTest() override
    {
        close(descriptor);
        fs::remove(path);
    }
    std::string content() const
    {
        std::ifstream file(path);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    fs::path path;
    int descriptor = -1;
};

TEST_F(MappedFileTest, HasTheBytesFromAPageOn)
{
    const auto file = MappedFile::open(descriptor, kPageBytes, kPageBytes + 1);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->bytes().size(), kPageBytes + 1);
    EXPECT_TRUE(std::ranges::all_of(file->bytes(), [](std::byte b) { return b == std::byte('b'); }));
}

TEST_F(MappedFileTest, StaysWhenItsFileIsRemovedAndWhatIsReleasedComesBack)
{
    auto file = MappedFile::open(descriptor, 0, kPageBytes);
    ASSERT_TRUE(file);
    fs::remove(path);
    EXPECT_EQ(file->bytes()[0], std::byte('a'));
    file->release(0, kPageBytes);
    EXPECT_EQ(file->bytes()[0], std::byte('a'));
    const MappedFile taken = std::move(*file);
    EXPECT_EQ(taken.bytes()[0], std::byte('a'));
    EXPECT_TRUE(file->bytes().empty());
}

TEST_F(MappedFileTest, WhatIsWrittenStaysInThisProcess)
{
    const auto file = MappedFile::open(descriptor, 0, kPageBytes);
    ASSERT_TRUE(file);
    file->bytes()[0] = std::byte('!');
    EXPECT_EQ(file->bytes()[0], std::byte('!'));
    EXPECT_EQ(content()[0], 'a');
}

TEST_F(MappedFileTest, NothingIsNotMappedNorIsWhatIsNoFile)
{
    EXPECT_FALSE(MappedFile::open(descriptor, 0, 0));
    EXPECT_FALSE(MappedFile::open(-1, 0, kPageBytes));
}

} // namespace
} // namespace torrance
