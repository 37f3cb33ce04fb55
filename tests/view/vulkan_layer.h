// What any Vulkan layer needs: the next one of the chain, and its own functions by name. For the one file of a layer,
// which defines instanceFunctions() and deviceFunctions().
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

namespace torrance::test {

/// The loader hands each layer the next one's functions, and its own, in a chain of structs.
template <typename LinkInfo>
LinkInfo* linkOf(const void* chain, VkStructureType type, VkLayerFunction function)
{
    for (auto* info = static_cast<const LinkInfo*>(chain); info; info = static_cast<const LinkInfo*>(info->pNext))
        if (info->sType == type && info->function == function)
            return const_cast<LinkInfo*>(info);
    return nullptr;
}

/// A function of the layer's own.
struct LayerFunction
{
    const char* name;
    PFN_vkVoidFunction function;
};

template <typename Function>
LayerFunction layerFunction(const char* name, Function function)
{
    return {name, reinterpret_cast<PFN_vkVoidFunction>(function)};
}

/// A row of a table of them: the function has Vulkan's type of this name.
#define TORRANCE_LAYER_FUNCTION(NAME, FUNCTION) torrance::test::layerFunction<PFN_##NAME>(#NAME, FUNCTION)

// Each layer's own, though a process may load several: what is inline would be one for all of them.
namespace {

PFN_vkGetInstanceProcAddr nextInstanceProc = nullptr;
PFN_vkGetDeviceProcAddr nextDeviceProc = nullptr;
VkInstance theInstance = VK_NULL_HANDLE;

/// What the layer does itself, besides what is here; everything else goes to the next one.
std::span<const LayerFunction> instanceFunctions();
std::span<const LayerFunction> deviceFunctions();

PFN_vkVoidFunction find(std::span<const LayerFunction> functions, const char* name)
{
    for (const LayerFunction& each : functions)
        if (std::strcmp(each.name, name) == 0)
            return each.function;
    return nullptr;
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* allocator,
                                              VkInstance* instance)
{
    auto* link = linkOf<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO,
                                                   VK_LAYER_LINK_INFO);
    if (!link)
        return VK_ERROR_INITIALIZATION_FAILED;
    nextInstanceProc = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(nextInstanceProc(VK_NULL_HANDLE, "vkCreateInstance"));
    const VkResult result = create(info, allocator, instance);
    theInstance = *instance;
    return result;
}

/// Has the next layer, or the driver, make a device.
VkResult createNextDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                          const VkAllocationCallbacks* allocator, VkDevice* device)
{
    auto* link =
        linkOf<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO, VK_LAYER_LINK_INFO);
    if (!link)
        return VK_ERROR_INITIALIZATION_FAILED;
    nextDeviceProc = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(
        link->u.pLayerInfo->pfnNextGetInstanceProcAddr(theInstance, "vkCreateDevice"));
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    return create(physical, info, allocator, device);
}

PFN_vkVoidFunction deviceProc(VkDevice device, const char* name)
{
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
        return layerFunction<PFN_vkGetDeviceProcAddr>(name, deviceProc).function;
    const PFN_vkVoidFunction own = find(deviceFunctions(), name);
    return own ? own : nextDeviceProc(device, name);
}

PFN_vkVoidFunction instanceProc(VkInstance instance, const char* name)
{
    const LayerFunction here[] = {TORRANCE_LAYER_FUNCTION(vkGetInstanceProcAddr, instanceProc),
                                  TORRANCE_LAYER_FUNCTION(vkGetDeviceProcAddr, deviceProc),
                                  TORRANCE_LAYER_FUNCTION(vkCreateInstance, createInstance)};
    for (const std::span<const LayerFunction> functions :
         {std::span<const LayerFunction>(here), instanceFunctions(), deviceFunctions()})
        if (const PFN_vkVoidFunction own = find(functions, name))
            return own;
    return nextInstanceProc(instance, name);
}

} // namespace
} // namespace torrance::test

/// By which the loader finds everything else.
extern "C" VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* interface)
{
    constexpr std::uint32_t kVersion = 2; // the first with this function
    if (interface->loaderLayerInterfaceVersion < kVersion)
        return VK_ERROR_INITIALIZATION_FAILED;
    interface->loaderLayerInterfaceVersion = kVersion;
    interface->pfnGetInstanceProcAddr = torrance::test::instanceProc;
    interface->pfnGetDeviceProcAddr = torrance::test::deviceProc;
    interface->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
