#include "test_device.h"

#include "passes/target_fill.h"

#include <gtest/gtest.h>

#include <array>

namespace torrance {
namespace {

// The content of a target after a rendering that draws nothing.
Image begun(TargetFill& fill, int width, int height, const ClearColor& color)
{
    const gpu::DeviceImage target = makeColorTarget(test::device(), width, height, "filled");
    const std::array targets = {&target};
    gpu::Commands commands(test::device());
    const ClearColor left = fill.fill(commands, targets, color);
    EXPECT_EQ(left.has_value(), !test::device().description.isProcessor()) << "a processor's targets are not cleared";
    beginRendering(commands, targets, nullptr, left, LoadTarget::clear);
    commands.buffer.endRendering();
    commands.submitAndWait();
    return readBack(test::device(), target);
}

void expectColor(const Image& image, const vec4& color)
{
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 4; ++c)
                ASSERT_EQ(image.at(x, y)[c], color[c]) << x << ' ' << y;
}

TEST(TargetFill, EachPixelHasTheColor)
{
    TargetFill fill(test::device());
    const vec4 color(0.25f, 3.0f, -1.0f, 0.5f);
    expectColor(begun(fill, 1, 1, color), color);
    expectColor(begun(fill, 70, 301, color), color);  // more rows than a strip has, and some over
    expectColor(begun(fill, 16384, 2, color), color); // the widest that all devices have: one row a strip
    expectColor(begun(fill, 70, 301, kClearToNothing), vec4(0.0f));
}

// More than are kept at a time, and again those that went.
TEST(TargetFill, ColorsTakeTurns)
{
    TargetFill fill(test::device());
    for (int turn = 0; turn < 2; ++turn)
        for (std::size_t i = 0; i <= TargetFill::kStrips; ++i) {
            const vec4 color(static_cast<float>(i), 0.5f, 0.25f, 1.0f);
            expectColor(begun(fill, 33, 17, color), color);
        }
}

// What lies there stays where nothing is cleared.
TEST(TargetFill, WhatIsKeptIsNotFilled)
{
    TargetFill fill(test::device());
    const gpu::DeviceImage target = makeColorTarget(test::device(), 8, 8, "kept");
    const std::array targets = {&target};
    const vec4 color(0.5f);
    for (const ClearColor& start : {ClearColor(color), kKeep}) {
        gpu::Commands commands(test::device());
        beginRendering(commands, targets, nullptr, fill.fill(commands, targets, start), LoadTarget::clear);
        commands.buffer.endRendering();
        commands.submitAndWait();
    }
    expectColor(readBack(test::device(), target), color);
}

} // namespace
} // namespace torrance
