// An image with memory of its own and one view of all of it.
#pragma once

#include "gpu/access.h"
#include "gpu/device.h"

#include <cstdint>
#include <string_view>

namespace torrance::gpu {

struct ImageShape
{
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    std::uint32_t mips = 1;
    std::uint32_t layers = 1;
    bool cube = false; // layers = 6, in Vulkan's order of faces
    vk::Format format = vk::Format::eUndefined;

    bool operator==(const ImageShape&) const = default;
};

struct DeviceImage
{
    vk::raii::DeviceMemory memory = nullptr; // before the handle: freed after it
    vk::raii::Image handle = nullptr;
    vk::raii::ImageView view = nullptr;
    vk::raii::ImageView depthView = nullptr; // of the depth alone, where there is a stencil beside it: to be sampled
    ImageShape shape;
    mutable AccessHistory history; // noted by Commands, also for who only reads

    vk::ImageAspectFlags aspect() const;
};

/// An Error (usage) names the size where the device cannot hold it.
DeviceImage makeImage(const Device& device, const ImageShape& shape, vk::ImageUsageFlags usage, std::string_view name);

bool isDepthFormat(vk::Format format);
bool hasStencil(vk::Format format);

} // namespace torrance::gpu
