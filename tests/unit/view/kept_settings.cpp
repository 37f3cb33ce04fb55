#include "view/kept_settings.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace torrance {
namespace {

class KeptFiles : public testing::Test
{
protected:
    void SetUp() override { std::filesystem::remove_all(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }
    // Of this test alone: others run beside it.
    std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) /
        ("torrance_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(KeptFiles, RecentFilesComeBackNewestFirst)
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

TEST_F(KeptFiles, ADamagedFileHoldsNothing)
{
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "recent.json") << "{\"recent\": [1,";
    EXPECT_TRUE(loadRecent(folder).empty());
    std::ofstream(folder / "recent.json") << "{\"recent\": [1]}";
    EXPECT_TRUE(loadRecent(folder).empty());
}

TEST_F(KeptFiles, AFolderThatCannotBeWrittenIsNoReasonToFail)
{
    std::ofstream(folder.string()) << "a file";
    EXPECT_EQ(keepRecent(folder, {}, "/a.glb").size(), 1u);
    keepSettings(folder, {});
    EXPECT_EQ(loadSettings(folder), KeptSettings());
}

TEST_F(KeptFiles, SettingsComeBack)
{
    EXPECT_EQ(loadSettings(folder), KeptSettings());
    const KeptSettings settings = {
        .windowSize = {800, 600}, .showPanels = false, .turntableFrames = 90, .tolerance = 0.0025, .lampSpeed = -12.5};
    keepSettings(folder, settings);
    EXPECT_EQ(loadSettings(folder), settings);
}

TEST_F(KeptFiles, NumbersOutOfRangeAndDamagedFilesAreTheDefaults)
{
    keepSettings(folder, {.windowSize = {1, 100000},
                          .showPanels = false,
                          .turntableFrames = 1000000,
                          .tolerance = -1.0,
                          .lampSpeed = 1e9});
    EXPECT_EQ(loadSettings(folder), (KeptSettings{.showPanels = false}));
    keepSettings(folder, {.windowSize = {1, 600}, .showPanels = false});
    EXPECT_EQ(loadSettings(folder), (KeptSettings{.showPanels = false})) << "half a size is none";
    std::ofstream(folder / "settings.json") << R"({"width": 800, "height": 600, "panels": 3})";
    EXPECT_EQ(loadSettings(folder), KeptSettings()) << "nothing is taken of a damaged file";
}

} // namespace
} // namespace torrance
