#include "files/environment_file.h"

#include "core/error.h"
#include "files/image_write.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

namespace fs = std::filesystem;

class EnvironmentFile : public ::testing::Test
{
protected:
    EnvironmentFile()
    {
        std::string name = (fs::temp_directory_path() / "torrance-environment-XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~EnvironmentFile() override { fs::remove_all(folder); }

    LoadedEnvironment through(const std::string& name, const Image& image)
    {
        const std::string path = (folder / name).string();
        writePicture(path, image, {}, {});
        return loadEnvironment(path);
    }

    fs::path folder;
};

TEST_F(EnvironmentFile, ReadsHdrAndExrAlike)
{
    // A power of two is exact in both.
    for (const char* name : {"a.hdr", "a.exr"}) {
        const LoadedEnvironment environment = through(name, Image(16, 8, 3, 0.25f));
        EXPECT_EQ(environment.radiance.texels, std::vector<float>(16 * 8 * 3, 0.25f)) << name;
        EXPECT_EQ(environment.replaced, 0u);
        EXPECT_TRUE(environment.warnings.empty()) << environment.warnings.front();
    }
}

TEST_F(EnvironmentFile, ReplacesAndCountsWhatIsNoRadiance)
{
    Image image(4, 2, 3, 1.0f);
    image.texels[1] = std::numeric_limits<float>::quiet_NaN();
    image.texels[5] = std::numeric_limits<float>::infinity();
    image.texels[9] = -2.0f;
    const LoadedEnvironment environment = through("a.exr", image);
    EXPECT_EQ(environment.replaced, 3u);
    ASSERT_EQ(environment.warnings.size(), 1u);
    for (const std::size_t index : {1, 5, 9})
        EXPECT_EQ(environment.radiance.texels[index], 0.0f);
    EXPECT_EQ(environment.radiance.texels[0], 1.0f);
}

TEST_F(EnvironmentFile, WarnsOfOtherProportions)
{
    EXPECT_EQ(through("a.exr", Image(4, 4, 3)).warnings.size(), 1u);
}

TEST_F(EnvironmentFile, DecodesDisplayReferredPictures)
{
    // The curve `none` of 0.5 is stored as its sRGB code; decoding gives it back within a step: 1/255 at slope below 2.
    const std::string path = (folder / "a.png").string();
    writePicture(path, Image(4, 2, 3, 0.5f), {}, {.tone = findToneCurve("none")});
    const LoadedEnvironment environment = loadEnvironment(path);
    EXPECT_NEAR(environment.radiance.texels[0], 0.5f, 1.0 / 255);
    EXPECT_EQ(environment.warnings.size(), 1u);
}

TEST_F(EnvironmentFile, RefusesByName)
{
    const auto problemOf = [](const std::string& path) -> std::string {
        try {
            loadEnvironment(path);
        } catch (const Error& error) {
            EXPECT_EQ(error.exitCode, ExitCode::input);
            return error.what();
        }
        return "";
    };
    const std::string missing = (folder / "missing.hdr").string(), empty = (folder / "empty.hdr").string();
    std::ofstream(empty).close();
    EXPECT_EQ(problemOf(missing).rfind(missing, 0), 0u);
    EXPECT_NE(problemOf(empty).find("is empty"), std::string::npos);
    EXPECT_NE(problemOf(folder.string()).find("is a directory"), std::string::npos);
}

} // namespace
} // namespace torrance
