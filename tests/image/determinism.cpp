// The same inputs give the same bytes: from two runs, any number of driver threads, two processes at once.
#include "drawing.h"
#include "gpu/test_device.h"
#include "plan/path_plan.h"
#include "scene/camera_fit.h"
#include "scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <unistd.h>
#include <vector>

namespace torrance::test {
namespace {

/// Set for the child processes below: where they leave their picture.
constexpr const char* kPictureVariable = "TORRANCE_TEST_PICTURE";

Picture drawTorus()
{
    Scene scene = texturedTorus();
    scene.materials[0].alphaMode = AlphaMode::blend;
    scene.materials[0].baseColorFactor.a = 0.7;
    scene.lights = {testLight(Light::Kind::directional), testLight(Light::Kind::point), testLight(Light::Kind::spot)};
    scene.environment = uniformEnvironment(dvec3(0.2, 0.3, 0.4));
    Settings settings = settingsOf("standard", 128);
    settings.samples = 4;
    return draw(scene, fitCamera(scene, {0.4, 1.0}, 1.0, 0.7, 0.05), settings);
}

using Bytes = std::vector<char>;

Bytes bytesOf(const Picture& picture)
{
    const auto* const first = reinterpret_cast<const char*>(picture.color.texels.data());
    return Bytes(first, first + picture.color.texels.size() * sizeof(float));
}

Bytes readBytes(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return Bytes(std::istreambuf_iterator<char>(file), {});
}

/// A process that draws the same picture; begun at once, waited for when it ends.
class Child
{
public:
    Child(const std::string& name, const std::string& variables)
        : path(std::filesystem::path(TORRANCE_BINARY_DIR) / ("determinism-" + name + "-" + std::to_string(getpid())))
    {
        const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
        const std::string command = variables + " " + kPictureVariable + "='" + path.string() + "' '" + program +
                                    "' --gtest_filter=Determinism.LeavesItsPicture > '" + path.string() + ".log' 2>&1";
        pipe = popen(command.c_str(), "r");
    }

    Bytes picture()
    {
        EXPECT_EQ(pclose(pipe), 0) << "see " << path.string() << ".log";
        Bytes bytes = readBytes(path);
        std::filesystem::remove(path);
        std::filesystem::remove(path.string() + ".log");
        return bytes;
    }

private:
    std::filesystem::path path;
    FILE* pipe = nullptr;
};

/// What a renderer draws before that leaves marks: it fills the picture with light that no other scene has.
void drawBright(Renderer& renderer, Settings settings)
{
    Scene scene;
    scene.materials.emplace_back().name = "lamp";
    scene.materials[0].emissiveFactor = dvec3(1e3);
    addInstance(scene, square(0), translation(dvec3(0.0, 0.0, -1.0)));
    settings.background = BackgroundKind::transparent;
    Camera camera;
    camera.kind = Camera::Kind::orthographic;
    camera.worldFromCamera[3] = dvec4(0.0, 0.0, 2.0, 1.0);
    camera.farPlane = 10.0;
    const ShadingPlan plan = makePlan(scene, settings);
    const DeviceScene onDevice = renderer.upload(scene, plan);
    const Picture bright = renderer.render(onDevice, camera);
    ASSERT_GT(pixelOf(bright, 0, 0).r, 100.0);
}

double greatestDifference(const Picture& a, const Picture& b)
{
    double greatest = 0.0;
    for (std::size_t i = 0; i < a.color.texels.size(); ++i)
        greatest = std::max(greatest, std::abs(double(a.color.texels[i]) - b.color.texels[i]));
    return greatest;
}

// A picture before a panorama is not cleared: every pixel is drawn.
TEST(Determinism, NothingIsLeftOfTheFrameBefore)
{
    Scene scene = texturedTorus();
    scene.lights = {testLight(Light::Kind::directional)};
    scene.environment = uniformEnvironment(dvec3(0.2, 0.3, 0.4));
    const Camera camera = fitCamera(scene, {0.4, 1.0}, 1.0, 0.7, 0.05);
    for (const RenderPath path : kRenderPaths) {
        Settings settings = settingsOf("standard", 96);
        settings.background = BackgroundKind::environment;
        settings.path = path;
        const ShadingPlan plan = makePlan(scene, settings);
        ASSERT_TRUE(plan.panorama);
        Renderer fresh(device(), shaders(), {}), used(device(), shaders(), {});
        drawBright(used, settings);
        const Picture first = fresh.render(fresh.upload(scene, plan), camera);
        const Picture second = used.render(used.upload(scene, plan), camera);
        EXPECT_EQ(greatestDifference(first, second), 0.0) << nameOf(path);
    }
}

TEST(Determinism, LeavesItsPicture)
{
    const Bytes bytes = bytesOf(drawTorus());
    EXPECT_FALSE(bytes.empty());
    if (const char* path = std::getenv(kPictureVariable)) // of the tests below, in other processes
        std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

TEST(Determinism, TwoRunsGiveTheSameBytes)
{
    const Bytes first = bytesOf(drawTorus());
    EXPECT_FALSE(first.empty());
    EXPECT_TRUE(first == bytesOf(drawTorus()));
}

TEST(Determinism, TheNumberOfThreadsChangesNothing)
{
    const Bytes none = Child("threads0", "LP_NUM_THREADS=0").picture();
    EXPECT_FALSE(none.empty());
    EXPECT_TRUE(none == Child("threads1", "LP_NUM_THREADS=1 TORRANCE_THREADS=1").picture());
    EXPECT_TRUE(none == Child("threads4", "LP_NUM_THREADS=4 TORRANCE_THREADS=4").picture());
}

TEST(Determinism, TwoProcessesAtOnceGiveTheSameBytes)
{
    Child one("one", "LP_NUM_THREADS=2");
    Child two("two", "LP_NUM_THREADS=2");
    const Bytes first = one.picture();
    EXPECT_FALSE(first.empty());
    EXPECT_TRUE(first == two.picture());
}

} // namespace
} // namespace torrance::test
