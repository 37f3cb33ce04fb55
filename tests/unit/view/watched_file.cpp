#include "view/watched_file.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace torrance {
namespace {

class WatchedFiles : public testing::Test
{
protected:
    void SetUp() override { std::filesystem::create_directories(folder / "below"); }
    void TearDown() override { std::filesystem::remove_all(folder); }

    // Later than anything that was written before, whatever the clock of the file system can tell apart.
    void write(const std::filesystem::path& file)
    {
        std::ofstream(file) << "x";
        time += std::chrono::seconds(10);
        std::filesystem::last_write_time(file, time);
    }

    // Of this test alone: others run beside it.
    std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) /
        ("torrance_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::file_time_type time = std::filesystem::file_time_type::clock::now();
};

TEST_F(WatchedFiles, AFileHasChangedOnceAfterItWasWritten)
{
    write(folder / "a");
    WatchedFile watched(folder / "a");
    EXPECT_FALSE(watched.takeChange());
    write(folder / "a");
    EXPECT_TRUE(watched.takeChange());
    EXPECT_FALSE(watched.takeChange());
}

TEST_F(WatchedFiles, AFileThatIsGoneHasNotChangedUntilItIsBack)
{
    write(folder / "a");
    WatchedFile watched(folder / "a");
    std::filesystem::remove(folder / "a");
    EXPECT_FALSE(watched.takeChange());
    write(folder / "a");
    EXPECT_TRUE(watched.takeChange());
}

TEST_F(WatchedFiles, AFolderChangesWithWhatLiesBelowIt)
{
    write(folder / "below" / "b");
    WatchedFile watched(folder);
    EXPECT_FALSE(watched.takeChange());
    write(folder / "below" / "b");
    EXPECT_TRUE(watched.takeChange());
    EXPECT_FALSE(watched.takeChange());
}

} // namespace
} // namespace torrance
