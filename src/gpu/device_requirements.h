// What Torrance asks of a Vulkan device, in one list, and how a device with it is made.
#pragma once

#include "gpu/device.h"

#include <optional>

namespace torrance::gpu {

DeviceDescription describe(const vk::raii::PhysicalDevice& physical);
std::optional<std::uint32_t> graphicsQueueFamily(const vk::raii::PhysicalDevice& physical);
bool supports(const vk::raii::PhysicalDevice& physical, Precision precision);
/// Whether depth can be drawn for four samples of a pixel, at Vulkan's standard places, the fragment shader running for
/// each.
bool samplesDepth(const vk::raii::PhysicalDevice& physical);
/// Whether memory of the host that lies on pages can be an image's.
bool importsHostPages(const vk::raii::PhysicalDevice& physical);
/// Whether its pictures can be shown in windows.
bool supportsSwapchain(const vk::raii::PhysicalDevice& physical);
/// With every precision that the device supports, the host's memory as images' where it can be, and what windows need
/// where its pictures are shown in one.
vk::raii::Device makeDevice(const vk::raii::PhysicalDevice& physical, std::uint32_t queueFamily, bool shows);

} // namespace torrance::gpu
