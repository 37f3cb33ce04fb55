#include "view/kept_settings.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace torrance {
namespace {

class KeptSettings : public testing::Test
{
protected:
    void SetUp() override { std::filesystem::remove_all(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }
    // Of this test alone: others run beside it.
    std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) /
        ("torrance_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(KeptSettings, RecentFilesComeBackNewestFirst)
{
    std::vector<std::string> recent = loadRecent(folder);
    EXPECT_TRUE(recent.empty());
    for (int i = 0; i < 12; ++i)
        recent = keepRecent(folder, recent, "/models/" + std::to_string(i) + ".glb");
    recent = keepRecent(folder, recent, "/models/5.glb");
    EXPECT_EQ(recent.size(), kMostRecent);
    EXPECT_EQ(recent[0], "/models/5.glb");
    EXPECT_EQ(recent[1], "/models/11.glb");
    EXPECT_EQ(loadRecent(folder), recent);
}

TEST_F(KeptSettings, ADamagedFileHoldsNothing)
{
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "recent.json") << "{\"recent\": [1,";
    EXPECT_TRUE(loadRecent(folder).empty());
    std::ofstream(folder / "recent.json") << "{\"recent\": [1]}";
    EXPECT_TRUE(loadRecent(folder).empty());
}

TEST_F(KeptSettings, AFolderThatCannotBeWrittenIsNoReasonToFail)
{
    std::ofstream(folder.string()) << "a file";
    EXPECT_EQ(keepRecent(folder, {}, "/a.glb").size(), 1u);
}

} // namespace
} // namespace torrance
