// An image with memory of its own and one view of all of it.
#pragma once

#include "core/mapped_file.h"
#include "gpu/access.h"
#include "gpu/device.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

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
    MappedFile texels;                       // what its memory is, of an image over the host's
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

/// How the levels of an image in rows lie in its memory, from large to small.
struct RowLayout
{
    struct Level
    {
        std::size_t offset = 0;
        std::size_t rowPitch = 0; // bytes from one row to the next

        bool operator==(const Level&) const = default;
    };
    std::vector<Level> levels;
    std::size_t bytes = 0; // of all of its memory

    bool operator==(const RowLayout&) const = default;
};

/// An image in rows can be sampled as well as any other: so it is on a processor, whose driver keeps all images in
/// rows.
bool canSampleRows(const Device& device, const ImageShape& shape);

/// Of an image in rows of one layer that is sampled.
RowLayout rowLayout(const Device& device, const ImageShape& shape);

/// The memory, of rowLayout()'s size, of a new image in rows: `write` fills it, and it stays mapped as long as the
/// image lives.
void writeRows(const DeviceImage& image, const std::function<void(std::byte* memory)>& write);

/// An image in rows, to be sampled, whose memory is these pages, laid out as rowLayout() says. Nothing where the device
/// does not take them, or would have them laid out otherwise; Device::importsHostPages() says whether it takes any.
std::optional<DeviceImage> makeImageOver(const Device& device, const ImageShape& shape, const RowLayout& layout,
                                         MappedFile texels, std::string_view name);

bool isDepthFormat(vk::Format format);
bool hasStencil(vk::Format format);

} // namespace torrance::gpu
