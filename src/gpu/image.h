// An image with memory of its own and one view of all of it.
#pragma once

#include "gpu/access.h"
#include "gpu/device.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

namespace torrance::gpu {

struct ImageShape
{
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    std::uint32_t mips = 1;
    std::uint32_t layers = 1;
    bool cube = false; // layers = 6, in Vulkan's order of faces
    vk::SampleCountFlagBits samples = vk::SampleCountFlagBits::e1;
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
    vk::Extent2D inMemory; // the sides that shaders are told, and that parts of sides are of: a texel more than the
                           // shape's at times
    mutable AccessHistory history; // noted by Commands, also for who only reads

    vk::ImageAspectFlags aspect() const;
};

/// Who lays out an image's texels.
enum class ImageTiling
{
    device, // filled by copies
    rows,   // row after row: the host writes them in place, before the image is first used
};

/// An Error (usage) names the size where the device cannot hold it.
DeviceImage makeImage(const Device& device, const ImageShape& shape, vk::ImageUsageFlags usage, std::string_view name,
                      ImageTiling tiling = ImageTiling::device);

/// Where a level of an image in rows lies in the host's memory.
struct LevelRows
{
    std::byte* texels = nullptr;
    std::size_t rowPitch = 0; // bytes from one to the next
};

/// An image in rows can be sampled as well as any other: so it is on a processor, whose driver keeps all images in
/// rows.
bool canSampleRows(const Device& device, const ImageShape& shape);

/// `write` fills the levels, from large to small, of a new image in rows of one layer: mapped as long as that lives.
void writeRows(const DeviceImage& image, const std::function<void(std::span<const LevelRows>)>& write);

bool isDepthFormat(vk::Format format);
bool hasStencil(vk::Format format);

} // namespace torrance::gpu
