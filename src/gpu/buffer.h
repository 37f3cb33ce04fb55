// A buffer with memory of its own, mapped for the host.
#pragma once

#include "gpu/access.h"
#include "gpu/device.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace torrance::gpu {

struct Buffer
{
    vk::raii::DeviceMemory memory = nullptr; // before the handle: freed after it
    vk::raii::Buffer handle = nullptr;
    vk::DeviceSize size = 0;
    std::byte* mapped = nullptr;   // host-visible and coherent
    mutable AccessHistory history; // noted by Commands, also for who only reads
};

/// Empty sizes are made 1 byte: Vulkan has no empty buffers, and a binding must hold something.
Buffer makeBuffer(const Device& device, vk::DeviceSize size, vk::BufferUsageFlags usage, std::string_view name);

/// The same, filled.
Buffer makeBuffer(const Device& device, std::span<const std::byte> content, vk::BufferUsageFlags usage,
                  std::string_view name);

/// For what the host writes and a copy takes to an image or a buffer: cached memory of the host. Who writes may read
/// again what it wrote (a level for the next one, a file's bytes for their hash), which from a card's memory takes a
/// hundred times as long.
Buffer makeStagingBuffer(const Device& device, vk::DeviceSize size, std::string_view name);

/// The same, filled.
Buffer makeStagingBuffer(const Device& device, std::span<const std::byte> content, std::string_view name);

/// For what the host reads back: cached memory where there is such.
Buffer makeReadbackBuffer(const Device& device, vk::DeviceSize size, std::string_view name);

} // namespace torrance::gpu
