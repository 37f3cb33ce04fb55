#include "gpu/access.h"

#include <array>
#include <gtest/gtest.h>

// The rules are those of the Vulkan specification's synchronization chapter: a read after a write needs an execution
// and a memory dependency, a write after a read an execution dependency only, a change of layout is a write.
namespace torrance::gpu {
namespace {

using Stage = vk::PipelineStageFlagBits2;
using Bit = vk::AccessFlagBits2;

const vk::Image kImage(reinterpret_cast<VkImage>(1));
const vk::Buffer kBuffer(reinterpret_cast<VkBuffer>(2));

Barriers next(AccessHistory& history, Access access, bool discard = false)
{
    const std::array use = {ImageUse{kImage, vk::ImageAspectFlagBits::eColor, &history, access, discard}};
    return barriersBefore(use, {});
}

Barriers nextBuffer(AccessHistory& history, Access access)
{
    const std::array use = {BufferUse{kBuffer, &history, access}};
    return barriersBefore({}, use);
}

TEST(Access, AttachmentThenSampledWaitsForTheWriteAndMakesItVisible)
{
    AccessHistory history;
    next(history, Access::colorAttachment, true);
    const Barriers barriers = next(history, Access::sampled);
    ASSERT_EQ(barriers.images.size(), 1u);
    const auto& barrier = barriers.images[0];
    EXPECT_EQ(barrier.srcStageMask, Stage::eColorAttachmentOutput);
    EXPECT_TRUE(barrier.srcAccessMask & Bit::eColorAttachmentWrite);
    EXPECT_EQ(barrier.dstStageMask, Stage::eFragmentShader);
    EXPECT_EQ(barrier.dstAccessMask, Bit::eShaderSampledRead);
    EXPECT_EQ(barrier.oldLayout, vk::ImageLayout::eColorAttachmentOptimal);
    EXPECT_EQ(barrier.newLayout, vk::ImageLayout::eShaderReadOnlyOptimal);
}

TEST(Access, WhatOthersFilledIsTakenOverOnceAndKept)
{
    AccessHistory history;
    history.layout = vk::ImageLayout::eGeneral;
    history.takenOverBy = 3;
    const Barriers barriers = next(history, Access::sampled);
    ASSERT_EQ(barriers.images.size(), 1u);
    EXPECT_EQ(barriers.images[0].oldLayout, vk::ImageLayout::eGeneral) << "undefined would lose the content";
    EXPECT_EQ(barriers.images[0].srcQueueFamilyIndex, VK_QUEUE_FAMILY_EXTERNAL);
    EXPECT_EQ(barriers.images[0].dstQueueFamilyIndex, 3u);
    const Barriers later = next(history, Access::transferRead);
    ASSERT_EQ(later.images.size(), 1u);
    EXPECT_EQ(later.images[0].srcQueueFamilyIndex, VK_QUEUE_FAMILY_IGNORED);
}

TEST(Access, AttachmentThenAttachmentIsAHazardToo)
{
    AccessHistory history;
    next(history, Access::colorAttachment, true);
    const Barriers barriers = next(history, Access::colorAttachment);
    ASSERT_EQ(barriers.images.size(), 1u) << "two passes that write one attachment are ordered";
    EXPECT_EQ(barriers.images[0].oldLayout, barriers.images[0].newLayout);
}

TEST(Access, SecondReadInAStageThatHasSeenTheWriteWaitsForNothing)
{
    AccessHistory history;
    next(history, Access::transferWrite, true);
    EXPECT_FALSE(next(history, Access::sampled).empty());
    EXPECT_TRUE(next(history, Access::sampled).empty());
}

TEST(Access, WriteAfterReadWaitsForTheReadOnly)
{
    AccessHistory history;
    nextBuffer(history, Access::transferRead);
    const Barriers barriers = nextBuffer(history, Access::transferWrite);
    ASSERT_EQ(barriers.buffers.size(), 1u);
    EXPECT_EQ(barriers.buffers[0].srcStageMask, Stage::eCopy);
    EXPECT_EQ(barriers.buffers[0].srcAccessMask, vk::AccessFlags2{}) << "a read leaves nothing to make visible";
}

TEST(Access, DiscardForgetsTheOldContentButStillWaits)
{
    AccessHistory history;
    next(history, Access::colorAttachment, true);
    next(history, Access::transferRead);
    const Barriers barriers = next(history, Access::colorAttachment, true);
    ASSERT_EQ(barriers.images.size(), 1u);
    EXPECT_EQ(barriers.images[0].oldLayout, vk::ImageLayout::eUndefined);
    EXPECT_TRUE(barriers.images[0].srcStageMask & Stage::eCopy) << "the copy may still be reading";
}

TEST(Access, EveryReaderWaitsForTheWriteItself)
{
    AccessHistory history;
    nextBuffer(history, Access::transferWrite);
    ASSERT_EQ(nextBuffer(history, Access::shaderRead).buffers.size(), 1u);
    const Barriers barriers = nextBuffer(history, Access::hostRead);
    ASSERT_EQ(barriers.buffers.size(), 1u);
    EXPECT_EQ(barriers.buffers[0].srcStageMask, Stage::eCopy);
    EXPECT_EQ(barriers.buffers[0].dstStageMask, Stage::eHost);
}

TEST(Access, DepthTestAfterDepthWriteIsOrdered)
{
    AccessHistory history;
    const std::array write = {
        ImageUse{kImage, vk::ImageAspectFlagBits::eDepth, &history, Access::depthAttachment, true}};
    const std::array test = {ImageUse{kImage, vk::ImageAspectFlagBits::eDepth, &history, Access::depthTest}};
    barriersBefore(write, {});
    const Barriers barriers = barriersBefore(test, {});
    ASSERT_EQ(barriers.images.size(), 1u);
    EXPECT_EQ(barriers.images[0].newLayout, vk::ImageLayout::eDepthStencilReadOnlyOptimal);
}

} // namespace
} // namespace torrance::gpu
