// An upload that is not wanted any more ends after the texture it is at.
#include "core/cancelled.h"
#include "drawing.h"
#include "gpu/test_device.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

TEST(StoppedUpload, MakesNoFurtherTexture)
{
    const Scene demo = demoScene();
    const ShadingPlan plan = makePlan(demo, settingsOf("standard", 16));
    Renderer renderer(device(), shaders(), {});
    int all = 0;
    renderer.upload(demo, plan, nullptr, [&](int) { ++all; });
    ASSERT_GT(all, 3) << "there are textures to be left out";
    int read = 0;
    EXPECT_THROW(renderer.upload(demo, plan, nullptr,
                                 [&](int) {
                                     if (++read == 2)
                                         throw Cancelled();
                                 }),
                 Cancelled);
    EXPECT_EQ(read, 2);
}

} // namespace
} // namespace torrance::test
