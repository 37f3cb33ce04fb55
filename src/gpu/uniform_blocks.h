// Many uniform blocks of one struct in a buffer, of which a draw binds one. A block that is bound by itself is read at
// constant offsets; what a shader indexes by a number of its own is read lane by lane on a software driver.
#pragma once

#include "gpu/pipeline.h"

#include <cstring>
#include <span>
#include <vector>

namespace torrance::gpu {

struct UniformBlocks
{
    Buffer buffer;
    vk::DeviceSize stride = 0;
    vk::DeviceSize size = 0; // of a block
    std::uint32_t binding = 0;

    void bind(Bindings& bindings, std::size_t index) const { bindings.set(binding, buffer, index * stride, size); }
};

template <typename Block>
UniformBlocks makeUniformBlocks(const Device& device, std::uint32_t binding, std::span<const Block> blocks,
                                std::string_view name)
{
    const vk::DeviceSize alignment = device.limits.minUniformBufferOffsetAlignment; // a power of two
    UniformBlocks result;
    result.size = sizeof(Block);
    result.stride = (sizeof(Block) + alignment - 1) & ~(alignment - 1);
    result.binding = binding;
    result.buffer = makeBuffer(device, blocks.size() * result.stride, vk::BufferUsageFlagBits::eUniformBuffer, name);
    for (std::size_t i = 0; i < blocks.size(); ++i)
        std::memcpy(result.buffer.mapped + i * result.stride, &blocks[i], sizeof(Block));
    return result;
}

} // namespace torrance::gpu
