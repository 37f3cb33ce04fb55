#include "test_device.h"

#include "passes/targets.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

// The validation layer fails the test where a layout is taken for granted that the device has not seen.
TEST(Commands, WhatWasNotSubmittedDidNotHappen)
{
    const gpu::DeviceImage image = makeColorTarget(test::device(), 8, 8, "half recorded");
    const vk::ImageLayout before = image.history.layout;
    {
        gpu::Commands forgotten(test::device());
        forgotten.use({gpu::use(image, gpu::Access::transferWrite, true)});
        forgotten.use({gpu::use(image, gpu::Access::sampled)});
        EXPECT_EQ(image.history.layout, vk::ImageLayout::eShaderReadOnlyOptimal);
    }
    EXPECT_EQ(image.history.layout, before);
    gpu::Commands commands(test::device());
    const gpu::DeviceImage* const targets[] = {&image};
    beginRendering(commands, targets, nullptr, vec4(0.25f), LoadTarget::clear);
    commands.buffer.endRendering();
    commands.submitAndWait();
    EXPECT_EQ(image.history.layout, vk::ImageLayout::eColorAttachmentOptimal);
    EXPECT_EQ(readBack(test::device(), image).at(3, 3)[0], 0.25f);
}

} // namespace
} // namespace torrance
