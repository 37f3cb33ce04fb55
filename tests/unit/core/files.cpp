// Files are read whole and written whole, or there is an error that says why.
#include "core/atomic_write.h"
#include "core/error.h"
#include "core/read_file.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace torrance {
namespace {

namespace fs = std::filesystem;

class Files : public ::testing::Test
{
protected:
    Files()
    {
        std::string name = (fs::temp_directory_path() / "torrance-files-XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~Files() override { fs::remove_all(folder); }

    std::string problemOfReading(const fs::path& path)
    {
        try {
            readFile(path);
        } catch (const Error& error) {
            EXPECT_EQ(error.exitCode, ExitCode::input);
            return error.what();
        }
        return "";
    }

    static std::string contentOf(const fs::path& path)
    {
        const std::vector<std::byte> bytes = readFile(path);
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }

    std::size_t fileCount() const
    {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
    }

    fs::path folder;
};

TEST_F(Files, ComeBackAsTheyWereWritten)
{
    const fs::path path = folder / "with space.bin";
    writeFile(path, std::string_view("one\0two", 7));
    writeFile(path, std::string_view("second"));
    EXPECT_EQ(contentOf(path), "second");
    EXPECT_EQ(fileCount(), 1u) << "no temporary file is left";
}

TEST_F(Files, ReadingSaysWhatIsWrong)
{
    std::ofstream(folder / "empty").close();
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_NE(problemOfReading(folder / "missing").find("No such file"), std::string::npos);
    EXPECT_NE(problemOfReading(folder / "empty").find("is empty"), std::string::npos);
    EXPECT_NE(problemOfReading(folder).find("is a directory"), std::string::npos);
    EXPECT_NE(problemOfReading(folder / "pipe").find("not a regular file"), std::string::npos) << "and does not hang";
}

TEST_F(Files, WritingLeavesNothingWhereItFails)
{
    fs::create_directory(folder / "taken");
    for (const fs::path& path : {folder / "missing" / "a.txt", folder / "taken"}) {
        try {
            writeFile(path, std::string_view("text"));
            FAIL() << path;
        } catch (const Error& error) {
            EXPECT_EQ(error.exitCode, ExitCode::cannotWrite);
        }
    }
    EXPECT_EQ(fileCount(), 1u);
}

TEST_F(Files, WhatACheckRefusesIsNotWritten)
{
    const fs::path path = folder / "checked.txt";
    const auto bytes = std::as_bytes(std::span("new", 3));
    writeFile(path, std::string_view("old"));
    const auto refuse = [&](const fs::path& written) {
        EXPECT_NE(written, path);
        EXPECT_EQ(fs::file_size(written), 3u) << "whole when it is looked at";
        throw std::runtime_error("not this one");
    };
    EXPECT_THROW(writeFile(path, bytes, refuse), std::runtime_error);
    EXPECT_EQ(contentOf(path), "old");
    EXPECT_EQ(fileCount(), 1u);
    writeFile(path, bytes, [](const fs::path&) {});
    EXPECT_EQ(contentOf(path), "new");
    EXPECT_THROW(writeFile("/dev/null", bytes, [](const fs::path&) {}), Error);
}

TEST_F(Files, DevicesAreWrittenToAndStay)
{
    writeFile("/dev/null", std::string_view("gone"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_THROW(writeFile("/dev/full", std::string_view("no room")), Error);
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

} // namespace
} // namespace torrance
