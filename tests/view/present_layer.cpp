// A Vulkan layer for tests: shows pictures in windows where the driver cannot, as those of data-centre GPUs cannot on
// the screen of the tests (Xvfb, without DRI3). Surfaces and swapchains are the layer's own: ordinary images, that are
// read back when they are presented, and put into the window through X.
//
// It knows what the window of torrance does and no more: one instance, device and queue, and one picture at a time
// from being acquired to being presented.
#define VK_USE_PLATFORM_XCB_KHR
#define VK_USE_PLATFORM_XLIB_KHR
#define VULKAN_HPP_DISPATCH_LOADER_DYNAMIC 1
#define VULKAN_HPP_NO_STRUCT_CONSTRUCTORS
#include "vulkan_layer.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <span>
#include <tuple>
#include <utility>
#include <vector>
#include <vulkan/vulkan.hpp>

VULKAN_HPP_DEFAULT_DISPATCH_LOADER_DYNAMIC_STORAGE

namespace torrance::test {
namespace {

const auto& next = VULKAN_HPP_DEFAULT_DISPATCHER; // the device's functions in the layer below, or in the driver
PFN_vkSetDeviceLoaderData setLoaderData = nullptr;
vk::Device theDevice;
VkPhysicalDeviceMemoryProperties theMemory = {};
vk::Queue theQueue;
std::uint32_t theQueueFamily = 0;
std::mutex queueMutex; // to the program, acquiring is no use of the queue; here it is one

template <typename Function>
VkResult resultOf(const Function& function)
{
    try {
        function();
        return VK_SUCCESS;
    } catch (const vk::SystemError& error) {
        return static_cast<VkResult>(error.code().value());
    }
}

template <typename Item>
VkResult give(std::span<const Item> all, std::uint32_t* count, Item* items)
{
    const auto available = static_cast<std::uint32_t>(all.size());
    *count = items ? std::min(*count, available) : available;
    if (items)
        std::copy_n(all.begin(), *count, items);
    return *count < available ? VK_INCOMPLETE : VK_SUCCESS;
}

// Windows.

constexpr vk::Format kFormat = vk::Format::eB8G8R8A8Unorm;
constexpr std::uint32_t kBytesPerPixel = 4; // of 24 bits, as X servers keep them

struct Surface
{
    // A connection of its own: the program's may be in the middle of something, in another thread.
    std::unique_ptr<xcb_connection_t, decltype(&xcb_disconnect)> connection;
    xcb_window_t window;
    xcb_gcontext_t context;
    std::uint8_t depth;
};

Surface& of(VkSurfaceKHR handle)
{
    return *reinterpret_cast<Surface*>(handle);
}

xcb_get_geometry_reply_t askGeometry(xcb_connection_t* connection, xcb_window_t window)
{
    const std::unique_ptr<xcb_get_geometry_reply_t, decltype(&std::free)> reply(
        xcb_get_geometry_reply(connection, xcb_get_geometry(connection, window), nullptr), std::free);
    if (!reply)
        throw vk::SurfaceLostKHRError("the window is gone");
    return *reply;
}

vk::Extent2D sizeOf(const Surface& surface)
{
    const xcb_get_geometry_reply_t geometry = askGeometry(surface.connection.get(), surface.window);
    return vk::Extent2D{geometry.width, geometry.height};
}

VkResult makeSurface(const char* display, xcb_window_t window, VkSurfaceKHR* handle)
{
    return resultOf([&] {
        Surface surface = {{xcb_connect(display, nullptr), xcb_disconnect}, window, 0, 0};
        xcb_connection_t* connection = surface.connection.get();
        if (xcb_connection_has_error(connection))
            throw vk::InitializationFailedError("no X server");
        surface.depth = askGeometry(connection, window).depth;
        surface.context = xcb_generate_id(connection);
        xcb_create_gc(connection, surface.context, window, 0, nullptr);
        *handle = reinterpret_cast<VkSurfaceKHR>(new Surface(std::move(surface)));
    });
}

VKAPI_ATTR VkResult VKAPI_CALL createXlibSurface(VkInstance, const VkXlibSurfaceCreateInfoKHR* info,
                                                 const VkAllocationCallbacks*, VkSurfaceKHR* surface)
{
    return makeSurface(DisplayString(info->dpy), static_cast<xcb_window_t>(info->window), surface);
}

VKAPI_ATTR VkResult VKAPI_CALL createXcbSurface(VkInstance, const VkXcbSurfaceCreateInfoKHR* info,
                                                const VkAllocationCallbacks*, VkSurfaceKHR* surface)
{
    return makeSurface(/* the one of DISPLAY */ nullptr, info->window, surface);
}

VKAPI_ATTR void VKAPI_CALL destroySurface(VkInstance, VkSurfaceKHR surface, const VkAllocationCallbacks*)
{
    delete reinterpret_cast<Surface*>(surface);
}

VKAPI_ATTR VkBool32 VKAPI_CALL getXlibSupport(VkPhysicalDevice, std::uint32_t, Display*, VisualID)
{
    return VK_TRUE;
}

VKAPI_ATTR VkBool32 VKAPI_CALL getXcbSupport(VkPhysicalDevice, std::uint32_t, xcb_connection_t*, xcb_visualid_t)
{
    return VK_TRUE;
}

VKAPI_ATTR VkResult VKAPI_CALL getSurfaceSupport(VkPhysicalDevice, std::uint32_t, VkSurfaceKHR, VkBool32* supported)
{
    *supported = VK_TRUE;
    return VK_SUCCESS;
}

VKAPI_ATTR VkResult VKAPI_CALL getSurfaceCapabilities(VkPhysicalDevice, VkSurfaceKHR surface,
                                                      VkSurfaceCapabilitiesKHR* capabilities)
{
    return resultOf([&] {
        const vk::Extent2D size = sizeOf(of(surface));
        using Usage = vk::ImageUsageFlagBits;
        *capabilities = vk::SurfaceCapabilitiesKHR{.minImageCount = 2,
                                                   .maxImageCount = 0, // as many as are wanted
                                                   .currentExtent = size,
                                                   .minImageExtent = size,
                                                   .maxImageExtent = size,
                                                   .maxImageArrayLayers = 1,
                                                   .supportedTransforms = vk::SurfaceTransformFlagBitsKHR::eIdentity,
                                                   .currentTransform = vk::SurfaceTransformFlagBitsKHR::eIdentity,
                                                   .supportedCompositeAlpha = vk::CompositeAlphaFlagBitsKHR::eOpaque,
                                                   .supportedUsageFlags = Usage::eTransferDst | Usage::eTransferSrc |
                                                                          Usage::eColorAttachment};
    });
}

VKAPI_ATTR VkResult VKAPI_CALL getSurfaceFormats(VkPhysicalDevice, VkSurfaceKHR, std::uint32_t* count,
                                                 VkSurfaceFormatKHR* formats)
{
    const VkSurfaceFormatKHR all[] = {{VkFormat(kFormat), VK_COLOR_SPACE_SRGB_NONLINEAR_KHR}};
    return give<VkSurfaceFormatKHR>(all, count, formats);
}

VKAPI_ATTR VkResult VKAPI_CALL getSurfacePresentModes(VkPhysicalDevice, VkSurfaceKHR, std::uint32_t* count,
                                                      VkPresentModeKHR* modes)
{
    const VkPresentModeKHR all[] = {VK_PRESENT_MODE_FIFO_KHR};
    return give<VkPresentModeKHR>(all, count, modes);
}

// Swapchains.

struct Swapchain
{
    Surface* surface = nullptr;
    vk::Extent2D size;
    std::vector<vk::UniqueDeviceMemory> memories;
    std::vector<vk::UniqueImage> images;
    vk::UniqueBuffer pixels; // what is shown, read back
    const std::uint8_t* mapped = nullptr;
    vk::UniqueCommandPool pool;
    std::vector<vk::CommandBuffer> copies; // by image: to the pixels
    vk::UniqueFence copied;
    std::uint32_t turn = 0; // of which image is acquired next
};

Swapchain& of(VkSwapchainKHR handle)
{
    return *reinterpret_cast<Swapchain*>(handle);
}

vk::DeviceMemory allocate(Swapchain& chain, const vk::MemoryRequirements& needs, vk::MemoryPropertyFlags wanted)
{
    for (std::uint32_t i = 0; i < theMemory.memoryTypeCount; ++i)
        if ((needs.memoryTypeBits >> i & 1u) &&
            (vk::MemoryPropertyFlags(theMemory.memoryTypes[i].propertyFlags) & wanted) == wanted)
        {
            const vk::MemoryAllocateInfo info = {.allocationSize = needs.size, .memoryTypeIndex = i};
            return *chain.memories.emplace_back(theDevice.allocateMemoryUnique(info));
        }
    throw vk::OutOfDeviceMemoryError("no " + vk::to_string(wanted));
}

void addImage(Swapchain& chain, vk::ImageUsageFlags usage)
{
    const vk::ImageCreateInfo info = {.imageType = vk::ImageType::e2D,
                                      .format = kFormat,
                                      .extent = {chain.size.width, chain.size.height, 1},
                                      .mipLevels = 1,
                                      .arrayLayers = 1,
                                      .usage = usage | vk::ImageUsageFlagBits::eTransferSrc};
    const vk::Image image = *chain.images.emplace_back(theDevice.createImageUnique(info));
    const vk::MemoryRequirements needs = theDevice.getImageMemoryRequirements(image);
    theDevice.bindImageMemory(image, allocate(chain, needs, vk::MemoryPropertyFlagBits::eDeviceLocal), 0);
}

void addPixels(Swapchain& chain)
{
    chain.pixels =
        theDevice.createBufferUnique({.size = vk::DeviceSize(kBytesPerPixel) * chain.size.width * chain.size.height,
                                      .usage = vk::BufferUsageFlagBits::eTransferDst});
    // Cached: what is not is read many times more slowly.
    using Property = vk::MemoryPropertyFlagBits;
    const vk::DeviceMemory memory = allocate(chain, theDevice.getBufferMemoryRequirements(*chain.pixels),
                                             Property::eHostVisible | Property::eHostCoherent | Property::eHostCached);
    theDevice.bindBufferMemory(*chain.pixels, memory, 0);
    chain.mapped = static_cast<const std::uint8_t*>(theDevice.mapMemory(memory, 0, VK_WHOLE_SIZE));
}

void recordCopy(const Swapchain& chain, vk::CommandBuffer commands, vk::Image image)
{
    using Stage = vk::PipelineStageFlagBits;
    vk::ImageMemoryBarrier change = {.dstAccessMask = vk::AccessFlagBits::eTransferRead,
                                     .oldLayout = vk::ImageLayout::ePresentSrcKHR,
                                     .newLayout = vk::ImageLayout::eTransferSrcOptimal,
                                     .image = image,
                                     .subresourceRange = {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}};
    commands.begin(vk::CommandBufferBeginInfo{});
    commands.pipelineBarrier(Stage::eTransfer, Stage::eTransfer, {}, {}, {}, change);
    const vk::BufferImageCopy region = {.imageSubresource = {vk::ImageAspectFlagBits::eColor, 0, 0, 1},
                                        .imageExtent = {chain.size.width, chain.size.height, 1}};
    commands.copyImageToBuffer(image, vk::ImageLayout::eTransferSrcOptimal, *chain.pixels, region);
    std::swap(change.oldLayout, change.newLayout);
    change.dstAccessMask = {};
    const vk::MemoryBarrier read = {.srcAccessMask = vk::AccessFlagBits::eTransferWrite,
                                    .dstAccessMask = vk::AccessFlagBits::eHostRead};
    commands.pipelineBarrier(Stage::eTransfer, Stage::eHost, {}, read, {}, change);
    commands.end();
}

void addCopies(Swapchain& chain)
{
    chain.pool = theDevice.createCommandPoolUnique({.queueFamilyIndex = theQueueFamily});
    chain.copies = theDevice.allocateCommandBuffers(
        {.commandPool = *chain.pool, .commandBufferCount = static_cast<std::uint32_t>(chain.images.size())});
    for (std::size_t i = 0; i < chain.copies.size(); ++i) {
        // The layers below know the device by it. For what the program allocates the loader does this itself.
        setLoaderData(theDevice, static_cast<VkCommandBuffer>(chain.copies[i]));
        recordCopy(chain, chain.copies[i], *chain.images[i]);
    }
    chain.copied = theDevice.createFenceUnique({});
}

VKAPI_ATTR VkResult VKAPI_CALL createSwapchain(VkDevice, const VkSwapchainCreateInfoKHR* info,
                                               const VkAllocationCallbacks*, VkSwapchainKHR* handle)
{
    return resultOf([&] {
        auto chain = std::make_unique<Swapchain>();
        chain->surface = &of(info->surface);
        chain->size = info->imageExtent;
        for (std::uint32_t i = 0; i < info->minImageCount; ++i)
            addImage(*chain, vk::ImageUsageFlags(info->imageUsage));
        addPixels(*chain);
        addCopies(*chain);
        *handle = reinterpret_cast<VkSwapchainKHR>(chain.release());
    });
}

VKAPI_ATTR void VKAPI_CALL destroySwapchain(VkDevice, VkSwapchainKHR handle, const VkAllocationCallbacks*)
{
    delete reinterpret_cast<Swapchain*>(handle);
}

VKAPI_ATTR VkResult VKAPI_CALL getSwapchainImages(VkDevice, VkSwapchainKHR handle, std::uint32_t* count,
                                                  VkImage* images)
{
    std::vector<VkImage> all;
    for (const vk::UniqueImage& image : of(handle).images)
        all.push_back(*image);
    return give<VkImage>(all, count, images);
}

void checkSize(const Swapchain& chain)
{
    if (sizeOf(*chain.surface) != chain.size)
        throw vk::OutOfDateKHRError("the window has another size");
}

void submit(const vk::SubmitInfo& info, vk::Fence fence)
{
    const std::lock_guard lock(queueMutex);
    theQueue.submit(info, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL acquireNextImage(VkDevice, VkSwapchainKHR handle, std::uint64_t, VkSemaphore semaphore,
                                                VkFence fence, std::uint32_t* index)
{
    return resultOf([&] {
        Swapchain& chain = of(handle);
        checkSize(chain);
        const vk::Semaphore acquired = semaphore;
        submit({.signalSemaphoreCount = acquired ? 1u : 0u, .pSignalSemaphores = &acquired}, fence);
        *index = chain.turn; // free, as all are: presenting waits until it has read
        chain.turn = (chain.turn + 1) % static_cast<std::uint32_t>(chain.images.size());
    });
}

void putIntoWindow(const Swapchain& chain)
{
    const Surface& surface = *chain.surface;
    xcb_connection_t* connection = surface.connection.get();
    // The server takes requests of so many bytes, with a head that is 4 bytes longer where they are long.
    const std::uint32_t most =
        4 * xcb_get_maximum_request_length(connection) - std::uint32_t(sizeof(xcb_put_image_request_t)) - 4;
    const std::uint32_t bytesPerRow = kBytesPerPixel * chain.size.width;
    const std::uint32_t rows = std::max(1u, most / bytesPerRow);
    for (std::uint32_t y = 0; y < chain.size.height; y += rows) {
        const std::uint32_t height = std::min(rows, chain.size.height - y);
        xcb_put_image(connection, XCB_IMAGE_FORMAT_Z_PIXMAP, surface.window, surface.context,
                      static_cast<std::uint16_t>(chain.size.width), static_cast<std::uint16_t>(height), 0,
                      static_cast<std::int16_t>(y), 0, surface.depth, height * bytesPerRow,
                      chain.mapped + std::size_t(y) * bytesPerRow);
    }
}

VKAPI_ATTR VkResult VKAPI_CALL queuePresent(VkQueue, const VkPresentInfoKHR* info)
{
    return resultOf([&] {
        vk::PresentInfoKHR present;
        present = *info;
        const Swapchain& chain = of(present.pSwapchains[0]);
        const std::vector<vk::PipelineStageFlags> stages(present.waitSemaphoreCount,
                                                         vk::PipelineStageFlagBits::eTransfer);
        submit({.waitSemaphoreCount = present.waitSemaphoreCount,
                .pWaitSemaphores = present.pWaitSemaphores,
                .pWaitDstStageMask = stages.data(),
                .commandBufferCount = 1,
                .pCommandBuffers = &chain.copies[present.pImageIndices[0]]},
               *chain.copied);
        std::ignore = theDevice.waitForFences(*chain.copied, true, UINT64_MAX);
        theDevice.resetFences(*chain.copied);
        putIntoWindow(chain);
        checkSize(chain); // the server answers after it has drawn
    });
}

// What the layer's own use of the queue must not meet, and what the driver must not be told of.

VKAPI_ATTR void VKAPI_CALL getDeviceQueue(VkDevice device, std::uint32_t family, std::uint32_t index, VkQueue* queue)
{
    next.vkGetDeviceQueue(device, family, index, queue);
    theQueue = *queue;
    theQueueFamily = family;
}

VKAPI_ATTR VkResult VKAPI_CALL queueSubmit(VkQueue queue, std::uint32_t count, const VkSubmitInfo* infos, VkFence fence)
{
    const std::lock_guard lock(queueMutex);
    return next.vkQueueSubmit(queue, count, infos, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL queueSubmit2(VkQueue queue, std::uint32_t count, const VkSubmitInfo2* infos,
                                            VkFence fence)
{
    const std::lock_guard lock(queueMutex);
    return next.vkQueueSubmit2(queue, count, infos, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL queueWaitIdle(VkQueue queue)
{
    const std::lock_guard lock(queueMutex);
    return next.vkQueueWaitIdle(queue);
}

VKAPI_ATTR VkResult VKAPI_CALL deviceWaitIdle(VkDevice device)
{
    const std::lock_guard lock(queueMutex);
    return next.vkDeviceWaitIdle(device);
}

VKAPI_ATTR VkResult VKAPI_CALL setObjectName(VkDevice device, const VkDebugUtilsObjectNameInfoEXT* info)
{
    if (info->objectType == VK_OBJECT_TYPE_SWAPCHAIN_KHR || info->objectType == VK_OBJECT_TYPE_SURFACE_KHR)
        return VK_SUCCESS; // nobody below knows it
    // Not of `next`: the loader's own, that every device has, is found only from above.
    return reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(nextDeviceProc(device, "vkSetDebugUtilsObjectNameEXT"))(
        device, info);
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* device)
{
    const auto* callback = linkOf<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO,
                                                           VK_LOADER_DATA_CALLBACK);
    if (!callback)
        return VK_ERROR_INITIALIZATION_FAILED;
    setLoaderData = callback->u.pfnSetDeviceLoaderData;
    const VkResult result = createNextDevice(physical, info, allocator, device);
    if (result != VK_SUCCESS)
        return result;
    theDevice = *device;
    VULKAN_HPP_DEFAULT_DISPATCHER.vkGetDeviceProcAddr = nextDeviceProc;
    VULKAN_HPP_DEFAULT_DISPATCHER.init(theDevice);
    reinterpret_cast<PFN_vkGetPhysicalDeviceMemoryProperties>(
        nextInstanceProc(theInstance, "vkGetPhysicalDeviceMemoryProperties"))(physical, &theMemory);
    return VK_SUCCESS;
}

const LayerFunction kDeviceFunctions[] = {
    TORRANCE_LAYER_FUNCTION(vkGetDeviceQueue, getDeviceQueue),
    TORRANCE_LAYER_FUNCTION(vkQueueSubmit, queueSubmit),
    TORRANCE_LAYER_FUNCTION(vkQueueSubmit2, queueSubmit2),
    TORRANCE_LAYER_FUNCTION(vkQueueWaitIdle, queueWaitIdle),
    TORRANCE_LAYER_FUNCTION(vkDeviceWaitIdle, deviceWaitIdle),
    TORRANCE_LAYER_FUNCTION(vkCreateSwapchainKHR, createSwapchain),
    TORRANCE_LAYER_FUNCTION(vkDestroySwapchainKHR, destroySwapchain),
    TORRANCE_LAYER_FUNCTION(vkGetSwapchainImagesKHR, getSwapchainImages),
    TORRANCE_LAYER_FUNCTION(vkAcquireNextImageKHR, acquireNextImage),
    TORRANCE_LAYER_FUNCTION(vkQueuePresentKHR, queuePresent),
    TORRANCE_LAYER_FUNCTION(vkSetDebugUtilsObjectNameEXT, setObjectName),
};
const LayerFunction kInstanceFunctions[] = {
    TORRANCE_LAYER_FUNCTION(vkCreateDevice, createDevice),
    TORRANCE_LAYER_FUNCTION(vkCreateXlibSurfaceKHR, createXlibSurface),
    TORRANCE_LAYER_FUNCTION(vkCreateXcbSurfaceKHR, createXcbSurface),
    TORRANCE_LAYER_FUNCTION(vkDestroySurfaceKHR, destroySurface),
    TORRANCE_LAYER_FUNCTION(vkGetPhysicalDeviceXlibPresentationSupportKHR, getXlibSupport),
    TORRANCE_LAYER_FUNCTION(vkGetPhysicalDeviceXcbPresentationSupportKHR, getXcbSupport),
    TORRANCE_LAYER_FUNCTION(vkGetPhysicalDeviceSurfaceSupportKHR, getSurfaceSupport),
    TORRANCE_LAYER_FUNCTION(vkGetPhysicalDeviceSurfaceCapabilitiesKHR, getSurfaceCapabilities),
    TORRANCE_LAYER_FUNCTION(vkGetPhysicalDeviceSurfaceFormatsKHR, getSurfaceFormats),
    TORRANCE_LAYER_FUNCTION(vkGetPhysicalDeviceSurfacePresentModesKHR, getSurfacePresentModes),
};

std::span<const LayerFunction> instanceFunctions()
{
    return kInstanceFunctions;
}

std::span<const LayerFunction> deviceFunctions()
{
    return kDeviceFunctions;
}

} // namespace
} // namespace torrance::test
