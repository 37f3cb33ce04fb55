#include "gpu/swapchain.h"

#include "core/error.h"

#include <algorithm>

namespace torrance::gpu {
namespace {

Error cannotShow(const Device& device, const std::string& why)
{
    return {ExitCode::noDevice,
            device.description.name + " cannot show pictures in this window: " + why + "; choose another device"};
}

// Codes are encoded by the display pass, so that no format that encodes by itself is wanted.
vk::SurfaceFormatKHR chooseFormat(const Device& device, const vk::raii::SurfaceKHR& surface)
{
    for (const vk::SurfaceFormatKHR& format : device.physical.getSurfaceFormatsKHR(*surface))
        if ((format.format == vk::Format::eB8G8R8A8Unorm || format.format == vk::Format::eR8G8B8A8Unorm) &&
            format.colorSpace == vk::ColorSpaceKHR::eSrgbNonlinear)
            return format;
    throw cannotShow(device, "it has no 8-bit format without a curve of its own");
}

vk::CompositeAlphaFlagBitsKHR chooseAlpha(vk::CompositeAlphaFlagsKHR supported)
{
    using Alpha = vk::CompositeAlphaFlagBitsKHR;
    return supported & Alpha::eOpaque ? Alpha::eOpaque : Alpha::eInherit;
}

} // namespace

Swapchain::Swapchain(const Device& d, vk::raii::SurfaceKHR s) : device(d), surface(std::move(s))
{
    if (!device.physical.getSurfaceSupportKHR(device.queueFamily, *surface))
        throw cannotShow(device, "its queue does not reach the window system");
    surfaceFormat = chooseFormat(device, surface);
    for (Frame& frame : frames) {
        frame.acquired = vk::raii::Semaphore(device.handle, vk::SemaphoreCreateInfo{});
        frame.done = vk::raii::Fence(device.handle, vk::FenceCreateInfo{.flags = vk::FenceCreateFlagBits::eSignaled});
        device.name(frame.acquired, "window picture acquired");
        device.name(frame.done, "window picture drawn");
    }
}

Swapchain::~Swapchain()
{
    waitAtEnd();
}

void Swapchain::waitAtEnd() const noexcept
{
    try {
        waitUntilIdle();
    } catch (const vk::SystemError&) { // lost: what was submitted has ended
    }
}

void Swapchain::waitUntilIdle() const
{
    const std::lock_guard lock(*device.queueMutex);
    device.handle.waitIdle();
}

std::optional<vk::Extent2D> Swapchain::prepare(const vk::Extent2D& wanted)
{
    const vk::SurfaceCapabilitiesKHR capabilities = device.physical.getSurfaceCapabilitiesKHR(*surface);
    constexpr std::uint32_t kLeftToUs = ~0u;
    vk::Extent2D size = capabilities.currentExtent;
    if (size.width == kLeftToUs)
        size = vk::Extent2D(
            std::clamp(wanted.width, capabilities.minImageExtent.width, capabilities.maxImageExtent.width),
            std::clamp(wanted.height, capabilities.minImageExtent.height, capabilities.maxImageExtent.height));
    if (size.width == 0 || size.height == 0)
        return std::nullopt;
    if (outOfDate || size != extent)
        create(capabilities, size);
    return extent;
}

void Swapchain::create(const vk::SurfaceCapabilitiesKHR& capabilities, const vk::Extent2D& size)
{
    if (!(capabilities.supportedUsageFlags & vk::ImageUsageFlagBits::eTransferDst))
        throw cannotShow(device, "nothing can be copied to its pictures");
    waitUntilIdle(); // the old pictures may still be copied to
    // One more than the least: the window system holds that many back.
    const std::uint32_t most = capabilities.maxImageCount == 0 ? ~0u : capabilities.maxImageCount;
    const vk::SwapchainCreateInfoKHR info = {.surface = *surface,
                                             .minImageCount = std::min(capabilities.minImageCount + 1, most),
                                             .imageFormat = surfaceFormat.format,
                                             .imageColorSpace = surfaceFormat.colorSpace,
                                             .imageExtent = size,
                                             .imageArrayLayers = 1,
                                             .imageUsage = vk::ImageUsageFlagBits::eTransferDst,
                                             .preTransform = capabilities.currentTransform,
                                             .compositeAlpha = chooseAlpha(capabilities.supportedCompositeAlpha),
                                             .presentMode = vk::PresentModeKHR::eFifo, // the one that all have
                                             .clipped = true,
                                             .oldSwapchain = *handle};
    handle = vk::raii::SwapchainKHR(device.handle, info);
    device.name(handle, "window");
    extent = size;
    outOfDate = false;
    images.clear();
    for (const VkImage image : handle.getImages())
        images.emplace_back(image);
    histories.assign(images.size(), {});
    drawn.clear();
    for (std::size_t i = 0; i < images.size(); ++i) {
        drawn.emplace_back(device.handle, vk::SemaphoreCreateInfo{});
        device.name(drawn.back(), "window picture to be shown");
    }
}

bool Swapchain::show(const DeviceImage& picture, const Record& record)
{
    Frame& frame = frames[next];
    if (device.handle.waitForFences(*frame.done, true, UINT64_MAX) != vk::Result::eSuccess)
        throw Error(ExitCode::deviceFailure, device.description.name + ": the work did not end; choose another device");
    std::uint32_t index = 0;
    try {
        const auto [result, image] = handle.acquireNextImage(UINT64_MAX, *frame.acquired);
        index = image;
        outOfDate = result == vk::Result::eSuboptimalKHR; // it can still be shown
    } catch (const vk::OutOfDateKHRError&) {
        outOfDate = true;
        return false;
    }
    frame.commands.emplace(device);
    frame.keep = record(*frame.commands);
    // The semaphore of the acquired picture is waited for before the copy, and so before the change of layout.
    histories[index] = {};
    histories[index].writeStages = vk::PipelineStageFlagBits2::eCopy;
    const auto useTarget = [&](Access access, bool discard) {
        return ImageUse{images[index], vk::ImageAspectFlagBits::eColor, &histories[index], access, discard};
    };
    frame.commands->use({use(picture, Access::transferRead), useTarget(Access::transferWrite, true)});
    const vk::ImageCopy region = {.srcSubresource = {vk::ImageAspectFlagBits::eColor, 0, 0, 1},
                                  .dstSubresource = {vk::ImageAspectFlagBits::eColor, 0, 0, 1},
                                  .extent = {extent.width, extent.height, 1}};
    frame.commands->buffer.copyImage(*picture.handle, vk::ImageLayout::eTransferSrcOptimal, images[index],
                                     vk::ImageLayout::eTransferDstOptimal, region);
    frame.commands->use({useTarget(Access::present, false)});
    device.handle.resetFences(*frame.done);
    frame.commands->submit(frame.acquired, drawn[index], frame.done);
    next = (next + 1) % frames.size();
    const vk::SwapchainKHR chain = *handle;
    const vk::Semaphore wait = *drawn[index];
    const std::lock_guard lock(*device.queueMutex);
    try {
        const vk::Result result = device.queue.presentKHR({.waitSemaphoreCount = 1,
                                                           .pWaitSemaphores = &wait,
                                                           .swapchainCount = 1,
                                                           .pSwapchains = &chain,
                                                           .pImageIndices = &index});
        outOfDate |= result == vk::Result::eSuboptimalKHR;
    } catch (const vk::OutOfDateKHRError&) {
        outOfDate = true;
        return false;
    }
    return true;
}

} // namespace torrance::gpu
