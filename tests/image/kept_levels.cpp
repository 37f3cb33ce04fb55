// Levels of textures out of files: the picture is that of levels made from texels, and large ones are the image's
// memory as they lie in the file.
#include "drawing.h"
#include "gpu/test_device.h"
#include "prepare/kept_textures.h"
#include "scene/camera_fit.h"
#include "scenes.h"
#include "tests/mapped_lines.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace torrance::test {
namespace {

namespace fs = std::filesystem;

class KeptLevelsTest : public testing::Test
{
protected:
    KeptLevelsTest() : folder(fs::temp_directory_path() / ("torrance-kept-levels-" + std::to_string(getpid())))
    {
        for (std::size_t i = 0; i < scene.images.size(); ++i)
            encoded.push_back(hashText("picture " + std::to_string(i)));
        camera = fitCamera(scene, {0.4, 1.0}, 1.0, 0.7, 0.05);
    }
    ~KeptLevelsTest() override { fs::remove_all(folder); }

    Image drawn(KeptTextures* kept)
    {
        const Settings settings = settingsOf("gltf", 64);
        const ShadingPlan plan =
            kept ? makePlan(scene, texelFacts(scene, encoded, *kept), settings) : makePlan(scene, settings);
        Renderer renderer(device(), shaders(), {});
        const DeviceScene uploaded = renderer.upload(scene, plan, nullptr, {}, {kept, encoded});
        mappedFiles = mappedLines(folder.filename().string());
        return renderer.render(uploaded, camera).color;
    }

    /// Kept levels that fill pages of their own (a head of a page before them), or not.
    std::size_t files(bool large) const
    {
        constexpr std::uintmax_t kLarge = 1 << 16;
        return static_cast<std::size_t>(
            std::count_if(fs::directory_iterator(folder / "textures"), fs::directory_iterator(),
                          [&](const auto& entry) { return (entry.file_size() > kLarge) == large; }));
    }

    Scene scene = demoScene();
    std::vector<ContentHash> encoded;
    Camera camera;
    fs::path folder;
    std::size_t mappedFiles = 0; // while the scene was on the device
};

TEST_F(KeptLevelsTest, AreTheImagesMemory)
{
    const Image plain = drawn(nullptr);
    KeptTextures kept(folder);
    EXPECT_EQ(drawn(&kept).texels, plain.texels) << "made, and kept";
    EXPECT_EQ(mappedFiles, 0u);
    ASSERT_GT(files(true), 0u);
    ASSERT_GT(files(false), 0u) << "those that are read";
    for (TextureImage& image : scene.images)
        image.texels.clear(); // nothing could be made from them
    EXPECT_EQ(drawn(&kept).texels, plain.texels);
    EXPECT_EQ(mappedFiles, device().importsHostPages() ? files(true) : 0);
}

TEST_F(KeptLevelsTest, AreTheSameBytesEachTime)
{
    KeptTextures kept(folder);
    drawn(&kept);
    const fs::path first = folder.string() + "-first";
    fs::rename(folder, first);
    drawn(&kept);
    for (const auto& entry : fs::directory_iterator(first / "textures")) {
        const auto content = [](const fs::path& path) {
            std::ifstream file(path, std::ios::binary);
            return std::string(std::istreambuf_iterator<char>(file), {});
        };
        EXPECT_TRUE(content(entry.path()) == content(folder / "textures" / entry.path().filename())) << entry.path();
    }
    fs::remove_all(first);
}

} // namespace
} // namespace torrance::test
