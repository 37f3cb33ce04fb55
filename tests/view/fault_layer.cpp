// A Vulkan layer for tests: makes what shows and submits pictures fail when it is asked to, as drivers do at times and
// a software driver never does.
//
// The file that TORRANCE_TEST_FAULT names asks for one failure by a line; once it has happened the file is called
// "<file>.taken" instead:
//
//   acquire out-of-date    acquire suboptimal    present out-of-date    present suboptimal
//   submit lost            from then on the device is lost: whatever is submitted or waited for says so
//
// "<file>.swapchains" gets a byte longer with each swapchain that is made.
#include "vulkan_layer.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>

namespace torrance::test {
namespace {

VkDevice theDevice = VK_NULL_HANDLE;
std::atomic<bool> lost = false;

template <typename Function>
Function next(const char* name)
{
    return reinterpret_cast<Function>(nextDeviceProc(theDevice, name));
}

const char* requestFile()
{
    return std::getenv("TORRANCE_TEST_FAULT");
}

// Whether this failure was asked for, which is said once.
bool takeFault(const char* fault)
{
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    const char* file = requestFile();
    if (!file)
        return false;
    std::string asked;
    std::getline(std::ifstream(file), asked);
    if (asked != fault)
        return false;
    std::filesystem::rename(file, std::string(file) + ".taken");
    return true;
}

// A lost device has stopped working: what was submitted has ended, well or not.
VkResult loseAfter(VkResult result)
{
    if (!lost)
        return result;
    next<PFN_vkDeviceWaitIdle>("vkDeviceWaitIdle")(theDevice);
    return VK_ERROR_DEVICE_LOST;
}

bool isLost()
{
    if (takeFault("submit lost"))
        lost = true;
    return lost;
}

VKAPI_ATTR VkResult VKAPI_CALL queueSubmit2(VkQueue queue, std::uint32_t count, const VkSubmitInfo2* infos,
                                            VkFence fence)
{
    if (isLost())
        return VK_ERROR_DEVICE_LOST;
    return next<PFN_vkQueueSubmit2>("vkQueueSubmit2")(queue, count, infos, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL waitForFences(VkDevice device, std::uint32_t count, const VkFence* fences, VkBool32 all,
                                             std::uint64_t nanoseconds)
{
    if (lost)
        return loseAfter(VK_SUCCESS); // the fence of what was never submitted
    return next<PFN_vkWaitForFences>("vkWaitForFences")(device, count, fences, all, nanoseconds);
}

VKAPI_ATTR VkResult VKAPI_CALL deviceWaitIdle(VkDevice device)
{
    return loseAfter(next<PFN_vkDeviceWaitIdle>("vkDeviceWaitIdle")(device));
}

VKAPI_ATTR VkResult VKAPI_CALL acquireNextImage(VkDevice device, VkSwapchainKHR swapchain, std::uint64_t nanoseconds,
                                                VkSemaphore semaphore, VkFence fence, std::uint32_t* index)
{
    if (lost)
        return VK_ERROR_DEVICE_LOST;
    if (takeFault("acquire out-of-date"))
        return VK_ERROR_OUT_OF_DATE_KHR;
    const VkResult result = next<PFN_vkAcquireNextImageKHR>("vkAcquireNextImageKHR")(device, swapchain, nanoseconds,
                                                                                     semaphore, fence, index);
    return result == VK_SUCCESS && takeFault("acquire suboptimal") ? VK_SUBOPTIMAL_KHR : result;
}

VKAPI_ATTR VkResult VKAPI_CALL queuePresent(VkQueue queue, const VkPresentInfoKHR* info)
{
    if (lost)
        return VK_ERROR_DEVICE_LOST;
    // The semaphores are waited for in any case.
    const VkResult result = next<PFN_vkQueuePresentKHR>("vkQueuePresentKHR")(queue, info);
    if (result == VK_SUCCESS && takeFault("present out-of-date"))
        return VK_ERROR_OUT_OF_DATE_KHR;
    return result == VK_SUCCESS && takeFault("present suboptimal") ? VK_SUBOPTIMAL_KHR : result;
}

VKAPI_ATTR VkResult VKAPI_CALL createSwapchain(VkDevice device, const VkSwapchainCreateInfoKHR* info,
                                               const VkAllocationCallbacks* allocator, VkSwapchainKHR* swapchain)
{
    if (const char* file = requestFile())
        std::ofstream(std::string(file) + ".swapchains", std::ios::app) << '.';
    return next<PFN_vkCreateSwapchainKHR>("vkCreateSwapchainKHR")(device, info, allocator, swapchain);
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* device)
{
    const VkResult result = createNextDevice(physical, info, allocator, device);
    theDevice = *device;
    return result;
}

const LayerFunction kDeviceFunctions[] = {
    TORRANCE_LAYER_FUNCTION(vkQueueSubmit2, queueSubmit2),
    TORRANCE_LAYER_FUNCTION(vkWaitForFences, waitForFences),
    TORRANCE_LAYER_FUNCTION(vkDeviceWaitIdle, deviceWaitIdle),
    TORRANCE_LAYER_FUNCTION(vkQueuePresentKHR, queuePresent),
    TORRANCE_LAYER_FUNCTION(vkAcquireNextImageKHR, acquireNextImage),
    TORRANCE_LAYER_FUNCTION(vkCreateSwapchainKHR, createSwapchain),
};
const LayerFunction kInstanceFunctions[] = {
    TORRANCE_LAYER_FUNCTION(vkCreateDevice, createDevice),
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
