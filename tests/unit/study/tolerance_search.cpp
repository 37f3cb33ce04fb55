// The search for a picture within a tolerance, with pictures that no device drew.
#include "study/tolerance_search.h"

#include "scene/camera_fit.h"
#include "study/method_table_file.h"
#include "tests/panorama_of.h"

#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace torrance {
namespace {

constexpr int kSize = 16;

MethodTable shippedTable()
{
    std::ostringstream text;
    text << std::ifstream(TORRANCE_SOURCE_DIR "/assets/methods.measured.json").rdbuf();
    return parseMethodTable(text.str(), "assets/methods.measured.json");
}

// Whatever is drawn is black: off by all of its light, little more than allowed, so that methods go up slowly. What is
// tried last is the nearest there is all the same: the exact plan would not be within either.
TEST(ToleranceSearch, EndsWithTheNearestMethods)
{
    Scene scene;
    Material& metal = scene.materials.emplace_back();
    metal.baseColorFactor = dvec4(0.8);
    metal.roughnessFactor = 0.3;
    scene.shapes.push_back({AnalyticShape::Kind::sphere, 0, dmat4(1.0), "sphere"});
    scene.environment = test::panoramaOf([](const dvec3& d) { return dvec3(0.6 + 0.4 * d.y); }, 32);
    Settings asked{.methods = *brdf::findPreset("standard")};
    asked.width = asked.height = kSize;
    const MethodTable table = shippedTable();
    const ToleranceTask task{.scene = scene,
                             .camera = fitCamera(scene, {0.3, 1.2}, 1.0, 0.7, 0.05),
                             .asked = asked,
                             .table = table,
                             .tolerance = {.mean = 0.95, .percentile99 = {}}};
    const Image black(kSize, kSize, 4);
    const ToleranceResult result = drawWithin(task, [&](const Settings&) -> const Image& { return black; });
    EXPECT_FALSE(result.holds);
    EXPECT_TRUE(isNearest(result.plan));
    EXPECT_EQ(result.trials.size(), static_cast<std::size_t>(kMostSteps) + 1);
    EXPECT_NE(result.obstacle.find("nearest methods"), std::string::npos) << result.obstacle;
}

} // namespace
} // namespace torrance
