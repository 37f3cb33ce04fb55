#include "gpu/access.h"

namespace torrance::gpu {

using Stage = vk::PipelineStageFlagBits2;
using Bit = vk::AccessFlagBits2;
using Layout = vk::ImageLayout;

AccessState stateOf(Access access)
{
    constexpr auto kDepthStages = Stage::eEarlyFragmentTests | Stage::eLateFragmentTests;
    switch (access) {
    case Access::colorAttachment:
        return {Stage::eColorAttachmentOutput, Bit::eColorAttachmentRead | Bit::eColorAttachmentWrite,
                Layout::eColorAttachmentOptimal, true};
    case Access::depthAttachment:
        return {kDepthStages, Bit::eDepthStencilAttachmentRead | Bit::eDepthStencilAttachmentWrite,
                Layout::eDepthStencilAttachmentOptimal, true};
    case Access::depthTest:
        return {kDepthStages | Stage::eFragmentShader, Bit::eDepthStencilAttachmentRead | Bit::eShaderSampledRead,
                Layout::eDepthStencilReadOnlyOptimal, false};
    case Access::sampled:
        return {Stage::eFragmentShader, Bit::eShaderSampledRead, Layout::eShaderReadOnlyOptimal, false};
    case Access::shaderRead:
        return {Stage::eVertexShader | Stage::eFragmentShader, Bit::eShaderStorageRead | Bit::eUniformRead,
                Layout::eUndefined, false};
    case Access::vertexRead:
        return {Stage::eVertexAttributeInput | Stage::eIndexInput, Bit::eVertexAttributeRead | Bit::eIndexRead,
                Layout::eUndefined, false};
    case Access::transferRead:
        return {Stage::eCopy, Bit::eTransferRead, Layout::eTransferSrcOptimal, false};
    case Access::transferWrite:
        return {Stage::eCopy, Bit::eTransferWrite, Layout::eTransferDstOptimal, true};
    case Access::hostRead:
        return {Stage::eHost, Bit::eHostRead, Layout::eGeneral, false};
    case Access::present: // what follows waits for a semaphore, which makes all visible
        return {Stage::eNone, {}, Layout::ePresentSrcKHR, false};
    }
    return {};
}

namespace {

struct Wait
{
    bool needed = false;
    vk::PipelineStageFlags2 stages;
    vk::AccessFlags2 access;
};

Wait advance(AccessHistory& history, const AccessState& next, bool changesLayout)
{
    Wait wait;
    if (next.writes || changesLayout) {
        wait.stages = history.writeStages | history.readStages;
        wait.access = history.writeAccess;
        wait.needed = changesLayout || bool(wait.stages);
        history = {.writeStages = next.stages,
                   .writeAccess = next.writes ? next.access : vk::AccessFlags2{},
                   .readStages = next.writes ? vk::PipelineStageFlags2{} : next.stages,
                   .visibleStages = next.stages,
                   .visibleAccess = next.access,
                   .layout = history.layout};
        return wait;
    }
    const bool seen =
        (history.visibleStages & next.stages) == next.stages && (history.visibleAccess & next.access) == next.access;
    wait.needed = bool(history.writeStages) && !seen;
    wait.stages = history.writeStages;
    wait.access = history.writeAccess;
    history.readStages |= next.stages;
    if (wait.needed) {
        // Several readers after one write: each waits for the write by itself.
        history.visibleStages = next.stages;
        history.visibleAccess = next.access;
    }
    return wait;
}

} // namespace

Barriers barriersBefore(std::span<const ImageUse> images, std::span<const BufferUse> buffers)
{
    Barriers barriers;
    for (const ImageUse& use : images) {
        const AccessState next = stateOf(use.access);
        AccessHistory& history = *use.history;
        const Layout oldLayout = history.layout;
        const std::uint32_t family = history.takenOverBy;
        const Wait wait = advance(history, next, oldLayout != next.layout);
        history.layout = next.layout;
        if (!wait.needed)
            continue;
        barriers.images.push_back(
            {.srcStageMask = wait.stages,
             .srcAccessMask = wait.access,
             .dstStageMask = next.stages,
             .dstAccessMask = next.access,
             .oldLayout = use.discard ? Layout::eUndefined : oldLayout,
             .newLayout = next.layout,
             .srcQueueFamilyIndex =
                 family == VK_QUEUE_FAMILY_IGNORED ? VK_QUEUE_FAMILY_IGNORED : VK_QUEUE_FAMILY_EXTERNAL,
             .dstQueueFamilyIndex = family,
             .image = use.image,
             .subresourceRange = {use.aspect, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS}});
    }
    for (const BufferUse& use : buffers) {
        const AccessState next = stateOf(use.access);
        const Wait wait = advance(*use.history, next, false);
        if (!wait.needed)
            continue;
        barriers.buffers.push_back({.srcStageMask = wait.stages,
                                    .srcAccessMask = wait.access,
                                    .dstStageMask = next.stages,
                                    .dstAccessMask = next.access,
                                    .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                    .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                    .buffer = use.buffer,
                                    .offset = 0,
                                    .size = VK_WHOLE_SIZE});
    }
    return barriers;
}

} // namespace torrance::gpu
