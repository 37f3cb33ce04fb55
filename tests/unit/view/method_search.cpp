#include "view/method_search.h"

#include "core/error.h"
#include "scene/camera_fit.h"
#include "tests/shipped_table.h"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace torrance {
namespace {

std::atomic<int> announced = 0;

void announce()
{
    ++announced;
}

// A rough sphere under half a sky.
Scene sphere()
{
    Scene scene;
    scene.environment = Environment{.name = "half", .radiance = Image(32, 16, 3)};
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 32; ++x)
            std::fill_n(scene.environment->radiance.at(x, y), 3, 1.0f);
    scene.materials.emplace_back();
    scene.shapes.push_back({.material = 0, .name = "ball"});
    return scene;
}

Settings small()
{
    Settings settings;
    settings.methods = *brdf::findPreset("standard");
    settings.width = settings.height = 16;
    return settings;
}

// Waits for what `holds` says.
template <typename Holds>
bool comes(const Holds& holds)
{
    for (int i = 0; i < 6000; ++i) {
        if (holds())
            return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

TEST(MethodSearch, AsksForPicturesAndSaysWhatItFound)
{
    const Scene scene = sphere();
    const Camera camera = fitCamera(scene, {}, 1.0, 0.8, 0.05);
    MethodSearch search(announce);
    announced = 0;
    search.start(scene, camera, small(), test::shippedTable(), {.mean = 0.01, .percentile99 = {}});
    std::optional<ToleranceResult> result;
    int pictures = 0;
    ASSERT_TRUE(comes([&] {
        if (search.wanted()) {
            search.give(Image(16, 16, 4, 0.0f)); // no method comes near this
            ++pictures;
            EXPECT_FALSE(search.wanted()) << "asked for once";
        }
        result = search.take();
        return result.has_value();
    }));
    EXPECT_FALSE(search.isRunning());
    EXPECT_FALSE(search.take());
    EXPECT_EQ(static_cast<int>(result->trials.size()), pictures);
    EXPECT_GT(pictures, 1) << "methods went up";
    EXPECT_FALSE(result->holds);
    EXPECT_FALSE(result->obstacle.empty());
    EXPECT_EQ(announced, pictures + 1);
}

TEST(MethodSearch, StopsWhileItComputesAndWhileItWaits)
{
    const Scene scene = sphere();
    const Camera camera = fitCamera(scene, {}, 1.0, 0.8, 0.05);
    MethodSearch search(announce);
    search.start(scene, camera, small(), test::shippedTable(), {.mean = 1e-5, .percentile99 = {}}); // minutes of truths
    search.stop();
    EXPECT_FALSE(search.isRunning());
    EXPECT_FALSE(search.take());
    search.start(scene, camera, small(), test::shippedTable(), {.mean = 0.5, .percentile99 = {}});
    ASSERT_TRUE(comes([&] { return search.wanted().has_value(); }));
    search.stop();
    EXPECT_FALSE(search.isRunning());
    EXPECT_FALSE(search.take());
}

TEST(MethodSearch, RefusesWhatHasNoExactLight)
{
    const Scene scene = sphere();
    Settings term = small();
    term.view = findView("roughness");
    MethodSearch search(announce);
    EXPECT_THROW(search.start(scene, Camera(), term, test::shippedTable(), {}), Error);
    EXPECT_FALSE(search.isRunning());
}

} // namespace
} // namespace torrance
