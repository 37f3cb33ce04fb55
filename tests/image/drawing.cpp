#include "drawing.h"

#include "files/image_write.h"
#include "gpu/test_device.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <sstream>

namespace torrance::test {
namespace {

std::unique_ptr<Renderer> theRenderer;

/// One renderer for all tests: what a pipeline costs is paid once. It goes before the device does.
Renderer& renderer()
{
    if (!theRenderer)
        theRenderer = std::make_unique<Renderer>(device(), shaders(), std::filesystem::path());
    return *theRenderer;
}

class RendererEnd : public testing::Environment
{
    void TearDown() override { theRenderer.reset(); }
};

const testing::Environment* const kRendererEnd = testing::AddGlobalTestEnvironment(new RendererEnd);

} // namespace

Settings settingsOf(std::string_view preset, int size)
{
    return squareSettings(*brdf::findPreset(preset), size);
}

Picture draw(const Scene& scene, const Camera& camera, const Settings& settings)
{
    const ShadingPlan plan = makePlan(scene, settings);
    const DeviceScene onDevice = renderer().upload(scene, plan);
    return renderer().render(onDevice, camera);
}

Picture drawForOneCamera(const Scene& scene, const Camera& camera, const Settings& settings)
{
    const ShadingPlan plan = makePlan(scene, settings);
    const DeviceScene onDevice = renderer().upload(scene, plan, &camera);
    return renderer().render(onDevice, camera);
}

dvec4 pixelOf(const Picture& picture, int x, int y)
{
    const float* p = picture.color.at(x, y);
    return dvec4(p[0], p[1], p[2], p[3]);
}

std::string keepFailure(const std::string& name, const Image& drawn, const Image& exact)
{
    const std::filesystem::path folder = std::filesystem::path(TORRANCE_BINARY_DIR) / "image-failures";
    std::filesystem::create_directories(folder);
    writePicture((folder / (name + "-drawn.exr")).string(), drawn, {}, {});
    writePicture((folder / (name + "-exact.exr")).string(), exact, {}, {});
    return (folder / name).string() + "-{drawn,exact}.exr";
}

void expectDrawnAsComputed(const std::vector<PictureCase>& cases)
{
    for (const PictureCase& c : cases) {
        const Picture picture = draw(c.scene, c.camera, c.settings);
        const PictureJudgement judgement = c.judge(c, picture.color);
        EXPECT_TRUE(judgement.passed()) << c.name << ": " << judgement.fault << ' ' << judgement.worst.text()
                                        << "; see " << keepFailure(c.name, picture.color, judgement.exact);
    }
}

} // namespace torrance::test
