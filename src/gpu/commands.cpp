#include "gpu/commands.h"

#include "core/error.h"

#include <algorithm>

namespace torrance::gpu {
namespace {

vk::raii::CommandPool makePool(const Device& device)
{
    return {device.handle, vk::CommandPoolCreateInfo{.flags = vk::CommandPoolCreateFlagBits::eTransient,
                                                     .queueFamilyIndex = device.queueFamily}};
}

vk::raii::CommandBuffer allocateBuffer(const Device& device, const vk::raii::CommandPool& pool)
{
    auto buffers = device.handle.allocateCommandBuffers(
        {.commandPool = *pool, .level = vk::CommandBufferLevel::ePrimary, .commandBufferCount = 1});
    return std::move(buffers.front());
}

} // namespace

Commands::Commands(const Device& d) : device(d), pool(makePool(d)), buffer(allocateBuffer(d, pool))
{
    d.name(pool, "frame commands");
    d.name(buffer, "frame commands");
    buffer.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    if (device.hooks.begun)
        device.hooks.begun(buffer);
}

Commands::~Commands()
{
    for (const auto& [history, old] : before)
        *history = old;
}

void Commands::use(std::span<const ImageUse> images, std::span<const BufferUse> buffers)
{
    for (const ImageUse& image : images)
        before.emplace(image.history, *image.history);
    for (const BufferUse& use : buffers)
        before.emplace(use.history, *use.history);
    const Barriers barriers = barriersBefore(images, buffers);
    if (!barriers.empty())
        buffer.pipelineBarrier2({.bufferMemoryBarrierCount = static_cast<std::uint32_t>(barriers.buffers.size()),
                                 .pBufferMemoryBarriers = barriers.buffers.data(),
                                 .imageMemoryBarrierCount = static_cast<std::uint32_t>(barriers.images.size()),
                                 .pImageMemoryBarriers = barriers.images.data()});
}

void Commands::end()
{
    if (device.hooks.ending)
        device.hooks.ending(buffer);
    buffer.end();
    before.clear();
}

void Commands::submitAndWait()
{
    end();
    const vk::raii::Fence fence(device.handle, vk::FenceCreateInfo{});
    device.name(fence, "frame fence");
    const vk::CommandBufferSubmitInfo commandInfo = {.commandBuffer = *buffer};
    {
        const std::lock_guard lock(*device.queueMutex);
        device.queue.submit2(vk::SubmitInfo2{.commandBufferInfoCount = 1, .pCommandBufferInfos = &commandInfo}, *fence);
    }
    // A software driver may take minutes for a huge picture: there is no time limit to set here.
    if (device.handle.waitForFences(*fence, true, UINT64_MAX) != vk::Result::eSuccess)
        throw Error(ExitCode::deviceFailure, device.description.name + ": the work did not end; choose another device");
}

void Commands::submit(const vk::raii::Semaphore& wait, const vk::raii::Semaphore& signal, const vk::raii::Fence& fence)
{
    end();
    const vk::CommandBufferSubmitInfo commandInfo = {.commandBuffer = *buffer};
    const vk::SemaphoreSubmitInfo waitInfo = {.semaphore = *wait, .stageMask = vk::PipelineStageFlagBits2::eCopy};
    const vk::SemaphoreSubmitInfo signalInfo = {.semaphore = *signal,
                                                .stageMask = vk::PipelineStageFlagBits2::eAllCommands};
    const std::lock_guard lock(*device.queueMutex);
    device.queue.submit2(vk::SubmitInfo2{.waitSemaphoreInfoCount = 1,
                                         .pWaitSemaphoreInfos = &waitInfo,
                                         .commandBufferInfoCount = 1,
                                         .pCommandBufferInfos = &commandInfo,
                                         .signalSemaphoreInfoCount = 1,
                                         .pSignalSemaphoreInfos = &signalInfo},
                         *fence);
}

ImageUse use(const DeviceImage& image, Access access, bool discard)
{
    return {*image.handle, image.aspect(), &image.history, access, discard};
}

BufferUse use(const Buffer& buffer, Access access)
{
    return {*buffer.handle, &buffer.history, access};
}

void copyToImage(Commands& commands, const Buffer& source, const DeviceImage& target, std::size_t bytesPerTexel)
{
    std::vector<vk::BufferImageCopy> regions;
    vk::DeviceSize offset = 0;
    for (std::uint32_t mip = 0; mip < target.shape.mips; ++mip) {
        const std::uint32_t width = std::max(target.shape.width >> mip, 1u);
        const std::uint32_t height = std::max(target.shape.height >> mip, 1u);
        regions.push_back({.bufferOffset = offset,
                           .imageSubresource = {target.aspect(), mip, 0, target.shape.layers},
                           .imageExtent = {width, height, 1}});
        offset += vk::DeviceSize(width) * height * target.shape.layers * bytesPerTexel;
    }
    commands.use({use(target, Access::transferWrite, true)}, {use(source, Access::transferRead)});
    commands.buffer.copyBufferToImage(*source.handle, *target.handle, vk::ImageLayout::eTransferDstOptimal, regions);
    commands.use({use(target, Access::sampled)});
}

void copyToBuffer(Commands& commands, const DeviceImage& source, const Buffer& target)
{
    commands.use({use(source, Access::transferRead)}, {use(target, Access::transferWrite)});
    const vk::BufferImageCopy region = {.imageSubresource = {source.aspect(), 0, 0, 1},
                                        .imageExtent = {source.shape.width, source.shape.height, 1}};
    commands.buffer.copyImageToBuffer(*source.handle, vk::ImageLayout::eTransferSrcOptimal, *target.handle, region);
    commands.use({}, {use(target, Access::hostRead)});
}

void copyImage(Commands& commands, const DeviceImage& source, const DeviceImage& target)
{
    constexpr bool kDiscard = true;
    commands.use({use(source, Access::transferRead), use(target, Access::transferWrite, kDiscard)});
    const vk::ImageCopy region = {.srcSubresource = {source.aspect(), 0, 0, 1},
                                  .dstSubresource = {target.aspect(), 0, 0, 1},
                                  .extent = {source.shape.width, source.shape.height, 1}};
    commands.buffer.copyImage(*source.handle, vk::ImageLayout::eTransferSrcOptimal, *target.handle,
                              vk::ImageLayout::eTransferDstOptimal, region);
}

} // namespace torrance::gpu
