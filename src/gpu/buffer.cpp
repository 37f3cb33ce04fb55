#include "gpu/buffer.h"

#include <algorithm>
#include <cstring>

namespace torrance::gpu {
namespace {

Buffer allocate(const Device& device, vk::DeviceSize size, vk::BufferUsageFlags usage,
                vk::MemoryPropertyFlags preferred, std::string_view name)
{
    Buffer buffer;
    buffer.size = std::max<vk::DeviceSize>(size, 1);
    vk::raii::Buffer handle(device.handle, vk::BufferCreateInfo{.size = buffer.size, .usage = usage});
    const vk::MemoryRequirements needs = handle.getMemoryRequirements();
    using Property = vk::MemoryPropertyFlagBits;
    const std::uint32_t type =
        device.memoryType(needs.memoryTypeBits, Property::eHostVisible | Property::eHostCoherent, preferred);
    buffer.memory = vk::raii::DeviceMemory(device.handle, {.allocationSize = needs.size, .memoryTypeIndex = type});
    buffer.handle = std::move(handle);
    buffer.handle.bindMemory(*buffer.memory, 0);
    buffer.mapped = static_cast<std::byte*>(buffer.memory.mapMemory(0, VK_WHOLE_SIZE));
    device.name(buffer.memory, name);
    device.name(buffer.handle, name);
    return buffer;
}

Buffer filled(Buffer buffer, std::span<const std::byte> content)
{
    if (!content.empty())
        std::memcpy(buffer.mapped, content.data(), content.size());
    return buffer;
}

} // namespace

Buffer makeBuffer(const Device& device, vk::DeviceSize size, vk::BufferUsageFlags usage, std::string_view name)
{
    return allocate(device, size, usage, vk::MemoryPropertyFlagBits::eDeviceLocal, name);
}

Buffer makeBuffer(const Device& device, std::span<const std::byte> content, vk::BufferUsageFlags usage,
                  std::string_view name)
{
    return filled(makeBuffer(device, content.size(), usage, name), content);
}

Buffer makeStagingBuffer(const Device& device, vk::DeviceSize size, std::string_view name)
{
    return allocate(device, size, vk::BufferUsageFlagBits::eTransferSrc, vk::MemoryPropertyFlagBits::eHostCached, name);
}

Buffer makeStagingBuffer(const Device& device, std::span<const std::byte> content, std::string_view name)
{
    return filled(makeStagingBuffer(device, content.size(), name), content);
}

Buffer makeReadbackBuffer(const Device& device, vk::DeviceSize size, std::string_view name)
{
    return allocate(device, size, vk::BufferUsageFlagBits::eTransferDst, vk::MemoryPropertyFlagBits::eHostCached, name);
}

} // namespace torrance::gpu
