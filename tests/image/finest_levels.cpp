// Levels of textures that a picture does not read change nothing in it when they are left out, but for the rounding of
// the level itself: 7.3 has three bits less behind the point than 0.3.
#include "drawing.h"
#include "plan/level_plan.h"
#include "scene/camera_fit.h"
#include "scenes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

/// A step of a float near 8 is 2^-20: the weight of a level, and with it a texel, moves by no more. Shading amplifies
/// that of a normal by a few times; a level too coarse would change pixels by per cents.
constexpr double kRelative = 1e-5;

TEST(FinestLevels, LeaveThePictureAsItIs)
{
    const Scene demo = demoScene();
    std::size_t left = 0;
    for (const double azimuth : {0.3, 1.9}) {
        const Camera camera = fitCamera(demo, {azimuth, 1.2}, 1.0, 0.7, 0.05);
        for (const auto& [path, samples] : {std::pair(RenderPath::forward, 2), {RenderPath::attributes, 1}}) {
            Settings settings = settingsOf("standard", 64);
            settings.samples = samples;
            settings.path = path;
            const std::vector<int> levels = finestLevels(demo, makePlan(demo, settings), camera);
            left += static_cast<std::size_t>(std::ranges::count_if(levels, [](int level) { return level > 0; }));
            const Picture all = draw(demo, camera, settings), some = drawForOneCamera(demo, camera, settings);
            for (std::size_t i = 0; i < all.color.texels.size(); ++i)
                ASSERT_NEAR(some.color.texels[i], all.color.texels[i], kRelative * all.color.texels[i])
                    << azimuth << ", " << samples << ", " << i;
        }
    }
    EXPECT_GT(left, 4u) << "nothing is left out, and nothing is tested";
}

} // namespace
} // namespace torrance::test
