// What any Vulkan layer needs: the next one of the chain, and its own functions by name.
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

/// Has the next layer, or the driver, make the instance; `proc` finds its functions.
inline VkResult createNextInstance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* allocator,
                                   VkInstance* instance, PFN_vkGetInstanceProcAddr& proc)
{
    auto* link = linkOf<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO,
                                                   VK_LAYER_LINK_INFO);
    if (!link)
        return VK_ERROR_INITIALIZATION_FAILED;
    proc = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(proc(VK_NULL_HANDLE, "vkCreateInstance"));
    return create(info, allocator, instance);
}

/// The same of a device of `instance`.
inline VkResult createNextDevice(VkInstance instance, VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                 const VkAllocationCallbacks* allocator, VkDevice* device,
                                 PFN_vkGetDeviceProcAddr& proc)
{
    auto* link =
        linkOf<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO, VK_LAYER_LINK_INFO);
    if (!link)
        return VK_ERROR_INITIALIZATION_FAILED;
    proc = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(
        link->u.pLayerInfo->pfnNextGetInstanceProcAddr(instance, "vkCreateDevice"));
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    return create(physical, info, allocator, device);
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

/// The one of this name, or null.
inline PFN_vkVoidFunction find(std::span<const LayerFunction> functions, const char* name)
{
    for (const LayerFunction& each : functions)
        if (std::strcmp(each.name, name) == 0)
            return each.function;
    return nullptr;
}

/// Of vkNegotiateLoaderLayerInterfaceVersion, by which the loader finds everything else.
inline VkResult negotiate(VkNegotiateLayerInterface* interface, PFN_vkGetInstanceProcAddr instanceProc,
                          PFN_vkGetDeviceProcAddr deviceProc)
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

} // namespace torrance::test

/// A row of a table of the layer's own functions: the function has Vulkan's type of this name.
#define TORRANCE_LAYER_FUNCTION(NAME, FUNCTION) torrance::test::layerFunction<PFN_##NAME>(#NAME, FUNCTION)
