#include "study/growth_scenes.h"

#include "plan/shading_plan.h"
#include "scene/camera_view.h"
#include "study/bench_item.h"

#include <gtest/gtest.h>
#include <string>

namespace torrance {
namespace {

const GrowthSeries& series(std::string_view id)
{
    for (const GrowthSeries& each : growthSeries())
        if (each.id == id)
            return each;
    throw std::out_of_range(std::string(id));
}

Settings settings()
{
    return {.methods = *brdf::findPreset("standard"), .width = 64, .height = 64};
}

double texelCount(const Scene& scene)
{
    double count = 0.0;
    for (const TextureImage& image : scene.images)
        count += double(image.width) * image.height;
    return count;
}

TEST(GrowthScenes, HaveTheSizesTheySay)
{
    for (const double size : series("triangles").sizes)
        EXPECT_EQ(static_cast<double>(triangleCount(series("triangles").makeScene(size))), size);
    for (const double size : series("lights").sizes) {
        const Scene scene = series("lights").makeScene(size);
        const ShadingPlan plan = makePlan(scene, settings());
        EXPECT_EQ(static_cast<double>(plan.lights.size()), size) << "none is left out";
    }
    for (const double size : series("texels").sizes) {
        if (size > 2e6) // seconds
            break;
        const Scene scene = series("texels").makeScene(size);
        EXPECT_EQ(texelCount(scene), size);
        const ShadingPlan plan = makePlan(scene, settings());
        ASSERT_EQ(plan.batches.size(), 1u);
        const TextureSet used = {0, -1, -1, -1, -1, -1};
        EXPECT_EQ(plan.batches[0].textures, used) << "the map is not taken for a constant";
    }
    for (const double size : series("pixels").sizes) {
        Settings picture = settings();
        series("pixels").setPicture(size, picture);
        EXPECT_EQ(double(picture.width) * picture.height, size);
    }
    EXPECT_EQ(series("pixels").sizes.back(), 8192.0 * 8192.0);
    EXPECT_EQ(series("lights").sizes.back(), 256.0);
}

TEST(GrowthScenes, DrawAnyNumberOfInstancesAtOnce)
{
    EXPECT_EQ(series("instances").sizes[3], 10000.0);
    for (const double size : series("instances").sizes) {
        const Scene scene = series("instances").makeScene(size);
        EXPECT_EQ(static_cast<double>(scene.instances.size()), size);
        EXPECT_EQ(drawCount(makePlan(scene, settings())), 1u);
    }
}

// What grows is not seen larger: of every series the whole scene fills the picture between the same margins, to a
// fifth.
TEST(GrowthScenes, CoverTheSamePartOfThePicture)
{
    for (const GrowthSeries& each : growthSeries()) {
        const auto extent = [&](double size) {
            const Scene scene = each.makeScene(size);
            const Camera camera = growthCamera(scene);
            const dmat4 clip = projectionMatrix(camera, 1.0) * viewFromWorld(camera);
            double greatest = 0.0;
            for (const Instance& instance : scene.instances)
                for (const vec3& position : scene.primitives[0].positions) {
                    const dvec4 world = instance.worldFromObject * dvec4(dvec3(position), 1.0);
                    const dvec4 p = clip * world;
                    greatest = std::max({greatest, std::abs(p.x / p.w), std::abs(p.y / p.w)});
                }
            return greatest;
        };
        const double first = extent(each.sizes[0]), second = extent(each.sizes[2]);
        EXPECT_NEAR(first, 0.9, 0.01) << each.id;
        EXPECT_NEAR(second, 0.9, 0.01) << each.id;
    }
}

} // namespace
} // namespace torrance
