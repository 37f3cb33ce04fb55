// The pictures that are drawn into.
#pragma once

#include "gpu/commands.h"
#include "gpu/image.h"
#include "image/image.h"
#include "math/vector.h"

#include <optional>
#include <span>
#include <vector>

namespace torrance {

inline constexpr vk::Format kColorFormat = vk::Format::eR32G32B32A32Sfloat;     // scene-linear float from first to last
inline constexpr vk::Format kAttributeFormat = vk::Format::eR32G32B32A32Uint;   // floats and flags as bits
inline constexpr vk::Format kDepthFormat = vk::Format::eD32Sfloat;              // reversed: 1 near, 0 far and empty
inline constexpr vk::Format kDepthStencilFormat = vk::Format::eD32SfloatS8Uint; // the same with numbers beside it

gpu::DeviceImage makeColorTarget(const gpu::Device& device, int width, int height, const char* name);
gpu::DeviceImage makeDepthTarget(const gpu::Device& device, int width, int height, const char* name);

/// Depth of four samples a pixel.
gpu::DeviceImage makeSampleDepthTarget(const gpu::Device& device, int width, int height);

/// One of kDepthStencilFormat, whose depth shaders may read.
gpu::DeviceImage makeDepthStencilTarget(const gpu::Device& device, int width, int height);

enum class LoadTarget
{
    clear,    // to 0
    keep,     // go on with what is there
    readOnly, // keep it: it is tested, and shaders may read it
};

/// What colours are cleared to before drawing; nothing: they are kept.
using ClearColor = std::optional<vec4>;
inline constexpr ClearColor kKeep = std::nullopt;
inline constexpr ClearColor kClearToNothing = vec4(0.0f); // no light, no coverage

/// Starts dynamic rendering into the targets, which are of one size, with viewport and scissor over all of them;
/// `colors` may be empty or `depth` null, not both.
void beginRendering(gpu::Commands& commands, std::span<const gpu::DeviceImage* const> colors,
                    const gpu::DeviceImage* depth, const ClearColor& clearColor, LoadTarget loadDepth);

/// One of 8-bit codes: what a screen is sent.
gpu::DeviceImage makeCodeTarget(const gpu::Device& device, vk::Format format, int width, int height, const char* name);

/// Codes of red, green, blue and alpha.
struct CodeImage
{
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> codes;

    const std::uint8_t* at(int x, int y) const
    {
        return codes.data() +
               4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    }
};

/// The content of a target of R8G8B8A8 or B8G8R8A8.
CodeImage readCodes(const gpu::Device& device, const gpu::DeviceImage& target);

/// The target's content, 4 channels.
Image readBack(const gpu::Device& device, const gpu::DeviceImage& target);

} // namespace torrance
