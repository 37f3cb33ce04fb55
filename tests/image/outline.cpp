// The line around what is selected.
#include "drawing.h"
#include "gpu/test_device.h"
#include "passes/outline_pass.h"
#include "passes/targets.h"
#include "scenes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

constexpr int kSize = 64;
constexpr int kWidth = 2; // pixels of the line

// Looks along -Z without perspective, two units to either side: 16 pixels a unit.
Camera frontCamera()
{
    Camera camera = {.name = "front",
                     .kind = Camera::Kind::orthographic,
                     .xmag = 2.0,
                     .ymag = 2.0,
                     .nearPlane = 0.1,
                     .farPlane = 100.0};
    camera.worldFromCamera[3] = dvec4(0.0, 0.0, 10.0, 1.0);
    return camera;
}

class OutlineOf
{
public:
    explicit OutlineOf(const Scene& s)
        : scene(s), plan(makePlan(s, settingsOf("gltf", kSize))), renderer(device(), shaders(), {}),
          uploaded(renderer.upload(scene, plan)), pass(device(), shaders())
    {
    }

    CodeImage instance(int index)
    {
        return readCodes(device(), pass.draw(uploaded, frontCamera(), index, ivec2(kSize)));
    }

private:
    const Scene& scene;
    ShadingPlan plan;
    Renderer renderer;
    DeviceScene uploaded;
    OutlinePass pass;
};

// A square of this half side, in pixels from the picture's middle, has a line of kWidth around it and nothing else.
void expectLineAround(const CodeImage& image, const ivec2& center, int half)
{
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const auto beyond = [&](int at, int middle) {
                return std::max(middle - half - at, at - (middle + half - 1));
            };
            const int outside = std::max(beyond(x, center.x), beyond(y, center.y));
            const std::uint8_t* code = image.at(x, y);
            EXPECT_EQ(code[3], outside > 0 && outside <= kWidth ? 255 : 0) << x << ", " << y;
            if (code[3] > 0) {
                EXPECT_EQ(code[0] & code[1] & code[2], 255) << "white, to be tinted";
            }
        }
}

TEST(Outline, GoesAroundOneInstanceWhateverStandsBeforeIt)
{
    Scene scene;
    scene.materials.emplace_back();
    const int back = addInstance(scene, square(0), dmat4(1.0));
    addInstance(scene, square(0), translation({0.0, 0.0, 1.0})); // hides it
    dmat4 small(0.5);
    small[3] = dvec4(1.0, 1.0, 2.0, 1.0);
    const int other = addInstance(scene, square(0), small);
    OutlineOf outline(scene);
    expectLineAround(outline.instance(back), {32, 32}, 16);
    expectLineAround(outline.instance(other), {48, 16}, 8);
    expectLineAround(outline.instance(back), {32, 32}, 16);
}

// As far from the origin as single floats hold no pixel of it.
TEST(Outline, HoldsFarFromTheOrigin)
{
    Scene scene;
    scene.materials.emplace_back();
    const int index = addInstance(scene, square(0), translation({1e7, 0.0, 0.0}));
    const ShadingPlan plan = makePlan(scene, settingsOf("gltf", kSize));
    Renderer renderer(device(), shaders(), {});
    const DeviceScene uploaded = renderer.upload(scene, plan);
    OutlinePass pass(device(), shaders());
    Camera camera = frontCamera();
    camera.worldFromCamera[3].x += 1e7;
    expectLineAround(readCodes(device(), pass.draw(uploaded, camera, index, ivec2(kSize))), {32, 32}, 16);
}

} // namespace
} // namespace torrance::test
