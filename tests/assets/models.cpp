// Real models, drawn and ray-cast: the folder that TORRANCE_ASSETS named when the build was configured.
#include "files/scene_file.h"
#include "image/mesh_truth.h"
#include "image/scenes.h"
#include "scene/camera_fit.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

constexpr double kTolerance = 2e-3; // as for the textured mesh
constexpr int kSize = 128;

std::vector<std::string> modelPaths()
{
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(TORRANCE_MODELS))
        if (entry.path().extension() == ".glb" || entry.path().extension() == ".gltf" ||
            entry.path().extension() == ".obj")
            paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

/// What the ray caster does not do is taken out: mips, blending, points and lines. One directional light.
Scene comparable(Scene scene)
{
    for (Texture& texture : scene.textures) {
        texture.sampler.mip = MipFilter::none;
        texture.sampler.magnify = texture.sampler.minify = Filter::linear;
    }
    for (Material& material : scene.materials)
        if (material.alphaMode == AlphaMode::blend)
            material.alphaMode = AlphaMode::opaque;
    std::erase_if(scene.instances, [&](const Instance& i) {
        return scene.primitives[static_cast<std::size_t>(i.primitive)].topology != Topology::triangles;
    });
    Light light;
    light.intensity = 3.0;
    light.direction = glm::normalize(dvec3(-0.4, -0.5, -1.0));
    scene.lights = {light};
    scene.environment.reset();
    return scene;
}

class RealModel : public testing::TestWithParam<std::string>
{
};

TEST_P(RealModel, AgreesWithRays)
{
    Scene scene;
    try {
        scene = comparable(loadScene(GetParam()).scene);
    } catch (const std::exception& refusal) {
        GTEST_SKIP() << refusal.what(); // by name, as tools/acceptance.sh checks
    }
    const Camera camera = fitCamera(scene, {0.5, 1.25}, 1.0, 0.7, 0.05);
    const Settings settings = settingsOf("gltf", kSize);
    const Picture picture = draw(scene, camera, settings);
    const std::vector<CastPixel> cast = castPicture(scene, settings.methods, camera, kSize, kSize);
    const Agreement agreement = compareToCast(picture, cast, kTolerance);
    EXPECT_EQ(agreement.coverageErrors, 0) << GetParam();
    EXPECT_LE(agreement.percentile99, kTolerance) << GetParam() << ": " << agreement.worst.text();
}

std::string testName(const testing::TestParamInfo<std::string>& info)
{
    std::string name = std::filesystem::path(info.param).stem().string() + "_" + std::to_string(info.index);
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Assets, RealModel, testing::ValuesIn(modelPaths()), testName);

} // namespace
} // namespace torrance::test
