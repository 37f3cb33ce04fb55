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
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

namespace {

PFN_vkGetInstanceProcAddr nextInstanceProc = nullptr;
PFN_vkGetDeviceProcAddr nextDeviceProc = nullptr;
VkInstance theInstance = VK_NULL_HANDLE;
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

// The loader hands each layer the next one's functions in a chain of structs.
template <typename LinkInfo>
LinkInfo* linkOf(const void* chain, VkStructureType type)
{
    for (auto* info = static_cast<const LinkInfo*>(chain); info; info = static_cast<const LinkInfo*>(info->pNext))
        if (info->sType == type && info->function == VK_LAYER_LINK_INFO)
            return const_cast<LinkInfo*>(info);
    return nullptr;
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* allocator,
                                              VkInstance* instance)
{
    auto* link = linkOf<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    if (!link)
        return VK_ERROR_INITIALIZATION_FAILED;
    nextInstanceProc = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(nextInstanceProc(VK_NULL_HANDLE, "vkCreateInstance"));
    const VkResult result = create(info, allocator, instance);
    theInstance = *instance;
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* device)
{
    auto* link = linkOf<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    if (!link)
        return VK_ERROR_INITIALIZATION_FAILED;
    nextDeviceProc = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(
        link->u.pLayerInfo->pfnNextGetInstanceProcAddr(theInstance, "vkCreateDevice"));
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const VkResult result = create(physical, info, allocator, device);
    theDevice = *device;
    return result;
}

PFN_vkVoidFunction deviceProc(VkDevice device, const char* name);

PFN_vkVoidFunction ownProc(const char* name)
{
    struct Row
    {
        const char* name;
        PFN_vkVoidFunction function;
    };
#define TORRANCE_ROW(NAME, FUNCTION)                                                                                   \
    {                                                                                                                  \
        NAME, reinterpret_cast<PFN_vkVoidFunction>(FUNCTION)                                                           \
    }
    static const Row kRows[] = {
        TORRANCE_ROW("vkGetDeviceProcAddr", deviceProc),       TORRANCE_ROW("vkQueueSubmit2", queueSubmit2),
        TORRANCE_ROW("vkWaitForFences", waitForFences),        TORRANCE_ROW("vkDeviceWaitIdle", deviceWaitIdle),
        TORRANCE_ROW("vkQueuePresentKHR", queuePresent),       TORRANCE_ROW("vkAcquireNextImageKHR", acquireNextImage),
        TORRANCE_ROW("vkCreateSwapchainKHR", createSwapchain),
    };
#undef TORRANCE_ROW
    for (const Row& row : kRows)
        if (std::strcmp(row.name, name) == 0)
            return row.function;
    return nullptr;
}

PFN_vkVoidFunction deviceProc(VkDevice device, const char* name)
{
    const PFN_vkVoidFunction own = ownProc(name);
    return own ? own : nextDeviceProc(device, name);
}

PFN_vkVoidFunction instanceProc(VkInstance instance, const char* name)
{
    if (std::strcmp(name, "vkGetInstanceProcAddr") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(instanceProc);
    if (std::strcmp(name, "vkCreateInstance") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(createInstance);
    if (std::strcmp(name, "vkCreateDevice") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(createDevice);
    const PFN_vkVoidFunction own = ownProc(name);
    return own ? own : nextInstanceProc(instance, name);
}

} // namespace

extern "C" VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* interface)
{
    constexpr std::uint32_t kVersion = 2; // the first with this function
    if (interface->loaderLayerInterfaceVersion < kVersion)
        return VK_ERROR_INITIALIZATION_FAILED;
    interface->loaderLayerInterfaceVersion = kVersion;
    interface->pfnGetInstanceProcAddr = instanceProc;
    interface->pfnGetDeviceProcAddr = deviceProc;
    interface->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
