// The pictures that are drawn into.
#pragma once

#include "gpu/commands.h"
#include "gpu/image.h"
#include "image/image.h"

#include <span>
#include <vector>

namespace torrance {

inline constexpr vk::Format kColorFormat = vk::Format::eR32G32B32A32Sfloat; // scene-linear float from first to last
inline constexpr vk::Format kDepthFormat = vk::Format::eD32Sfloat;          // reversed: 1 near, 0 far and empty

gpu::DeviceImage makeColorTarget(const gpu::Device& device, int width, int height, const char* name);
gpu::DeviceImage makeDepthTarget(const gpu::Device& device, int width, int height);

enum class LoadTarget
{
    clear, // to 0
    keep,
};

/// Starts dynamic rendering into the targets with viewport and scissor over all of them; `depth` may be null.
void beginRendering(gpu::Commands& commands, std::span<const gpu::DeviceImage* const> colors,
                    const gpu::DeviceImage* depth, LoadTarget loadColor, LoadTarget loadDepth);

/// The target's content, 4 channels.
Image readBack(const gpu::Device& device, const gpu::DeviceImage& target);

} // namespace torrance
