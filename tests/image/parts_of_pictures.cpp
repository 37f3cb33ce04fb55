// A picture that is drawn only in some boxes holds there what the whole picture does.
#include "drawing.h"
#include "gpu/test_device.h"
#include "plan/path_plan.h"
#include "scene/camera_fit.h"
#include "scenes.h"
#include "two_paths.h"

#include <gtest/gtest.h>
#include <random>

namespace torrance::test {
namespace {

/// Blocks round one pixel of 40.
std::vector<PixelBox> someBlocks(int width, int height)
{
    std::mt19937 random(3);
    std::vector<ivec2> pixels;
    for (int i = 0; i < width * height / 40; ++i)
        pixels.emplace_back(int(random() % unsigned(width)), int(random() % unsigned(height)));
    return blocksAround(pixels, width, height);
}

/// A picture keeps what is not drawn. In a new target that is whatever lay in its memory, the whole picture of the
/// renderer before as like as not: here it is a colour that no picture has.
Picture drawnOverPurple(const Scene& scene, const Camera& camera, const ShadingPlan& plan,
                        std::span<const PixelBox> only)
{
    Renderer renderer(device(), shaders(), {});
    Settings purple = plan.settings;
    purple.path = {};
    purple.background = BackgroundKind::color;
    purple.backgroundColor = dvec3(7.0, 0.0, 7.0);
    const Scene nothing;
    const ShadingPlan blank = makePlan(nothing, purple);
    renderer.render(renderer.upload(nothing, blank), camera);
    return renderer.render(renderer.upload(scene, plan), camera, {}, only);
}

void expectPartsOfTheWhole(const Scene& scene, const Camera& camera, const Settings& settings, const std::string& name)
{
    const ShadingPlan plan = makePlan(scene, settings);
    const std::vector<PixelBox> only = someBlocks(settings.width, settings.height);
    const Picture whole = drawnOverPurple(scene, camera, plan, {}), parts = drawnOverPurple(scene, camera, plan, only);
    EXPECT_TRUE(parts.layers.empty());
    std::vector<bool> inside(std::size_t(settings.width) * std::size_t(settings.height));
    int seen = 0, left = 0;
    for (const PixelBox& box : only)
        for (int y = box.first.y; y < box.beyond.y; ++y)
            for (int x = box.first.x; x < box.beyond.x; ++x) {
                inside[std::size_t(y) * std::size_t(settings.width) + std::size_t(x)] = true;
                EXPECT_EQ(pixelOf(parts, x, y), pixelOf(whole, x, y)) << name << " at " << x << ", " << y;
                seen += pixelOf(whole, x, y).a > 0.0;
            }
    for (int y = 0; y < settings.height; ++y)
        for (int x = 0; x < settings.width; ++x)
            left += !inside[std::size_t(y) * std::size_t(settings.width) + std::size_t(x)] &&
                    pixelOf(parts, x, y) != pixelOf(whole, x, y);
    EXPECT_GT(seen, 50) << name;
    EXPECT_GT(left, 50) << name << ": nothing was left out";
}

TEST(PartsOfPictures, AreThoseOfTheWhole)
{
    Scene torus = texturedTorus();
    torus.lights = {testLight(Light::Kind::directional)};
    torus.environment = uniformEnvironment(dvec3(1.0, 0.9, 0.8));
    const Scene all = sceneOfAllSurfaces();
    for (const RenderPath path : kRenderPaths)
        for (const int samples : {1, 2}) {
            Settings settings = settingsOf("standard", 70); // not whole blocks
            settings.path = path;
            settings.samples = samples;
            const std::string name = nameOf(path) + std::string(", ") + std::to_string(samples);
            expectPartsOfTheWhole(torus, fitCamera(torus, {0.4, 1.0}, 1.0, 0.7, 0.05), settings, "torus, " + name);
            expectPartsOfTheWhole(all, orthographicCamera(), settings, "all surfaces, " + name);
        }
}

// With levels of textures, which a device tells by a pixel's neighbours, and a panorama behind.
TEST(PartsOfPictures, ReadTheSameLevelsOfTextures)
{
    const Scene demo = demoScene();
    for (const RenderPath path : {RenderPath::prepass, RenderPath::attributes}) {
        Settings settings = settingsOf("standard", 96);
        settings.background = BackgroundKind::environment;
        settings.path = path;
        settings.layers = true;
        expectPartsOfTheWhole(demo, fitCamera(demo, {0.3, 1.2}, 1.0, 0.7, 0.05), settings, nameOf(path));
    }
}

} // namespace
} // namespace torrance::test
