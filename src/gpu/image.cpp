#include "gpu/image.h"

#include "core/error.h"
#include "core/huge_pages.h"

#include <bit>
#include <cassert>
#include <vector>

namespace torrance::gpu {
namespace {

using MemoryBit = vk::MemoryPropertyFlagBits;

constexpr vk::DeviceSize kLargeImage = 4 << 20; // holds a large page whole

/// A software driver's memory is the host's, and is touched for the first time when an image is filled.
void preferHugePagesOnHost(const Device& device, const vk::raii::DeviceMemory& memory, std::uint32_t type,
                           vk::DeviceSize size)
{
    const bool mappable = bool(device.memory.memoryTypes[type].propertyFlags & MemoryBit::eHostVisible);
    if (!device.description.isProcessor() || !mappable || size < kLargeImage)
        return;
    preferHugePages(memory.mapMemory(0, VK_WHOLE_SIZE), size);
    memory.unmapMemory();
}

// A software driver compiles a shader anew for pictures whose sides are powers of two, and the same for all others:
// colours that are drawn and sampled later always are of the others. Not depth, whose size shaders ask for.
bool isSampledColor(vk::ImageUsageFlags usage)
{
    return (usage & vk::ImageUsageFlagBits::eSampled) && (usage & vk::ImageUsageFlagBits::eColorAttachment);
}

std::uint32_t sideInMemory(std::uint32_t side, vk::ImageUsageFlags usage, std::uint32_t limit)
{
    return isSampledColor(usage) && std::has_single_bit(side) && side < limit ? side + 1 : side;
}

} // namespace

bool isDepthFormat(vk::Format format)
{
    return format == vk::Format::eD32Sfloat || hasStencil(format);
}

bool hasStencil(vk::Format format)
{
    return format == vk::Format::eD32SfloatS8Uint;
}

vk::ImageAspectFlags DeviceImage::aspect() const
{
    using Aspect = vk::ImageAspectFlagBits;
    if (hasStencil(shape.format))
        return Aspect::eDepth | Aspect::eStencil;
    return isDepthFormat(shape.format) ? Aspect::eDepth : Aspect::eColor;
}

DeviceImage makeImage(const Device& device, const ImageShape& shape, vk::ImageUsageFlags usage, std::string_view name,
                      ImageTiling tiling)
{
    const std::uint32_t limit = device.limits.maxImageDimension2D;
    if (shape.width > limit || shape.height > limit)
        throw usageError(std::to_string(shape.width) + "x" + std::to_string(shape.height) + " is more than " +
                             device.description.name + " can hold (" + std::to_string(limit) + " a side)",
                         "choose a smaller size");
    const bool inRows = tiling == ImageTiling::rows;
    const vk::Extent2D inMemory = {sideInMemory(shape.width, usage, limit), sideInMemory(shape.height, usage, limit)};
    const vk::ImageCreateInfo info = {
        .flags = shape.cube ? vk::ImageCreateFlagBits::eCubeCompatible : vk::ImageCreateFlags{},
        .imageType = vk::ImageType::e2D,
        .format = shape.format,
        .extent = {inMemory.width, inMemory.height, 1},
        .mipLevels = shape.mips,
        .arrayLayers = shape.layers,
        .samples = shape.samples,
        .tiling = inRows ? vk::ImageTiling::eLinear : vk::ImageTiling::eOptimal,
        .usage = usage,
        .initialLayout = inRows ? vk::ImageLayout::ePreinitialized : vk::ImageLayout::eUndefined};
    DeviceImage image;
    image.shape = shape;
    image.inMemory = inMemory;
    image.history.layout = info.initialLayout;
    vk::raii::Image handle(device.handle, info);
    const vk::MemoryRequirements needs = handle.getMemoryRequirements();
    const std::uint32_t type = device.memoryType(
        needs.memoryTypeBits, inRows ? MemoryBit::eHostVisible | MemoryBit::eHostCoherent : vk::MemoryPropertyFlags{},
        MemoryBit::eDeviceLocal);
    image.memory = vk::raii::DeviceMemory(device.handle, {.allocationSize = needs.size, .memoryTypeIndex = type});
    preferHugePagesOnHost(device, image.memory, type, needs.size);
    image.handle = std::move(handle);
    image.handle.bindMemory(*image.memory, 0);
    image.view = vk::raii::ImageView(
        device.handle,
        {.image = *image.handle,
         .viewType = shape.cube ? vk::ImageViewType::eCube : vk::ImageViewType::e2D,
         .format = shape.format,
         .subresourceRange = {.aspectMask = image.aspect(), .levelCount = shape.mips, .layerCount = shape.layers}});
    if (hasStencil(shape.format) && (usage & vk::ImageUsageFlagBits::eSampled)) {
        image.depthView =
            vk::raii::ImageView(device.handle, {.image = *image.handle,
                                                .viewType = vk::ImageViewType::e2D,
                                                .format = shape.format,
                                                .subresourceRange = {.aspectMask = vk::ImageAspectFlagBits::eDepth,
                                                                     .levelCount = shape.mips,
                                                                     .layerCount = shape.layers}});
        device.name(image.depthView, name);
    }
    device.name(image.memory, name);
    device.name(image.handle, name);
    device.name(image.view, name);
    return image;
}

bool canSampleRows(const Device& device, const ImageShape& shape)
{
    if (!device.description.isProcessor() || shape.layers != 1)
        return false;
    constexpr auto kNeeded =
        vk::FormatFeatureFlagBits::eSampledImage | vk::FormatFeatureFlagBits::eSampledImageFilterLinear;
    if ((device.physical.getFormatProperties(shape.format).linearTilingFeatures & kNeeded) != kNeeded)
        return false;
    try {
        const vk::ImageFormatProperties limits = device.physical.getImageFormatProperties(
            shape.format, vk::ImageType::e2D, vk::ImageTiling::eLinear, vk::ImageUsageFlagBits::eSampled);
        return shape.width <= limits.maxExtent.width && shape.height <= limits.maxExtent.height &&
               shape.mips <= limits.maxMipLevels;
    } catch (const vk::FormatNotSupportedError&) {
        return false;
    }
}

void writeRows(const DeviceImage& image, const std::function<void(std::span<const LevelRows>)>& write)
{
    assert(image.history.layout == vk::ImageLayout::ePreinitialized);
    auto* const mapped = static_cast<std::byte*>(image.memory.mapMemory(0, VK_WHOLE_SIZE));
    std::vector<LevelRows> levels;
    for (std::uint32_t mip = 0; mip < image.shape.mips; ++mip) {
        const vk::SubresourceLayout layout = image.handle.getSubresourceLayout({image.aspect(), mip, 0});
        levels.push_back({mapped + layout.offset, layout.rowPitch});
    }
    write(levels);
}

} // namespace torrance::gpu
