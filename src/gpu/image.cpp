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

namespace {

using Usage = vk::ImageUsageFlagBits;

vk::ImageCreateInfo createInfo(const ImageShape& shape, const vk::Extent2D& inMemory, vk::ImageUsageFlags usage,
                               ImageTiling tiling)
{
    const bool inRows = tiling == ImageTiling::rows;
    return {.flags = shape.cube ? vk::ImageCreateFlagBits::eCubeCompatible : vk::ImageCreateFlags{},
            .imageType = vk::ImageType::e2D,
            .format = shape.format,
            .extent = {inMemory.width, inMemory.height, 1},
            .mipLevels = shape.mips,
            .arrayLayers = shape.layers,
            .samples = shape.samples,
            .tiling = inRows ? vk::ImageTiling::eLinear : vk::ImageTiling::eOptimal,
            .usage = usage,
            .initialLayout = inRows ? vk::ImageLayout::ePreinitialized : vk::ImageLayout::eUndefined};
}

/// Joins the image's handle and its memory, makes the views, and gives all of them their names.
void complete(const Device& device, DeviceImage& image, vk::raii::Image handle, vk::ImageUsageFlags usage,
              std::string_view name)
{
    const ImageShape& shape = image.shape;
    image.handle = std::move(handle);
    image.handle.bindMemory(*image.memory, 0);
    image.view = vk::raii::ImageView(
        device.handle,
        {.image = *image.handle,
         .viewType = shape.cube ? vk::ImageViewType::eCube : vk::ImageViewType::e2D,
         .format = shape.format,
         .subresourceRange = {.aspectMask = image.aspect(), .levelCount = shape.mips, .layerCount = shape.layers}});
    if (hasStencil(shape.format) && (usage & Usage::eSampled)) {
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
}

RowLayout layoutOf(const vk::raii::Image& image, std::uint32_t mips)
{
    RowLayout layout = {.levels = {}, .bytes = image.getMemoryRequirements().size};
    for (std::uint32_t mip = 0; mip < mips; ++mip) {
        const vk::SubresourceLayout place = image.getSubresourceLayout({vk::ImageAspectFlagBits::eColor, mip, 0});
        layout.levels.push_back({place.offset, place.rowPitch});
    }
    return layout;
}

/// The pages that hold the bytes.
vk::DeviceSize wholePages(std::size_t bytes)
{
    return (bytes + kPageBytes - 1) / kPageBytes * kPageBytes;
}

} // namespace

DeviceImage makeImage(const Device& device, const ImageShape& shape, vk::ImageUsageFlags usage, std::string_view name,
                      ImageTiling tiling)
{
    const std::uint32_t limit = device.limits.maxImageDimension2D;
    if (shape.width > limit || shape.height > limit)
        throw usageError(std::to_string(shape.width) + "x" + std::to_string(shape.height) + " is more than " +
                             device.description.name + " can hold (" + std::to_string(limit) + " a side)",
                         "choose a smaller size");
    const bool inRows = tiling == ImageTiling::rows;
    DeviceImage image;
    image.shape = shape;
    image.inMemory = vk::Extent2D{sideInMemory(shape.width, usage, limit), sideInMemory(shape.height, usage, limit)};
    const vk::ImageCreateInfo info = createInfo(shape, image.inMemory, usage, tiling);
    image.history.layout = info.initialLayout;
    vk::raii::Image handle(device.handle, info);
    const vk::MemoryRequirements needs = handle.getMemoryRequirements();
    const std::uint32_t type = device.memoryType(
        needs.memoryTypeBits, inRows ? MemoryBit::eHostVisible | MemoryBit::eHostCoherent : vk::MemoryPropertyFlags{},
        MemoryBit::eDeviceLocal);
    image.memory = vk::raii::DeviceMemory(device.handle, {.allocationSize = needs.size, .memoryTypeIndex = type});
    preferHugePagesOnHost(device, image.memory, type, needs.size);
    complete(device, image, std::move(handle), usage, name);
    return image;
}

bool canSampleRows(const Device& device, const ImageShape& shape)
{
    if (!device.description.isProcessor() || shape.layers != 1)
        return false;
    using Feature = vk::FormatFeatureFlagBits;
    const vk::FormatProperties features = device.physical.getFormatProperties(shape.format);
    // Whole numbers have no filter, in rows as in any order.
    const vk::FormatFeatureFlags needed =
        features.optimalTilingFeatures & (Feature::eSampledImage | Feature::eSampledImageFilterLinear);
    if (!(needed & Feature::eSampledImage) || (features.linearTilingFeatures & needed) != needed)
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

RowLayout rowLayout(const Device& device, const ImageShape& shape)
{
    return layoutOf(vk::raii::Image(device.handle,
                                    createInfo(shape, {shape.width, shape.height}, Usage::eSampled, ImageTiling::rows)),
                    shape.mips);
}

void writeRows(const DeviceImage& image, const std::function<void(std::byte*)>& write)
{
    assert(image.history.layout == vk::ImageLayout::ePreinitialized);
    write(static_cast<std::byte*>(image.memory.mapMemory(0, VK_WHOLE_SIZE)));
}

std::optional<DeviceImage> makeImageOver(const Device& device, const ImageShape& shape, const RowLayout& layout,
                                         MappedFile texels, std::string_view name)
{
    constexpr auto kPages = vk::ExternalMemoryHandleTypeFlagBits::eHostAllocationEXT;
    void* const pages = texels.bytes().data();
    const vk::ExternalMemoryImageCreateInfo external = {.handleTypes = kPages};
    vk::ImageCreateInfo info = createInfo(shape, {shape.width, shape.height}, Usage::eSampled, ImageTiling::rows);
    info.pNext = &external;
    info.initialLayout = vk::ImageLayout::eUndefined; // an external image has no other: its content is taken over
    vk::raii::Image handle(device.handle, info);
    const std::uint32_t types = handle.getMemoryRequirements().memoryTypeBits &
                                device.handle.getMemoryHostPointerPropertiesEXT(kPages, pages).memoryTypeBits;
    if (types == 0 || texels.bytes().size() != layout.bytes || layoutOf(handle, shape.mips) != layout)
        return std::nullopt;
    DeviceImage image;
    image.shape = shape;
    image.inMemory = vk::Extent2D{shape.width, shape.height};
    image.history.layout = vk::ImageLayout::eGeneral; // as the host leaves it
    image.history.takenOverBy = device.queueFamily;
    const vk::ImportMemoryHostPointerInfoEXT import = {.handleType = kPages, .pHostPointer = pages};
    image.memory = vk::raii::DeviceMemory(device.handle, {.pNext = &import,
                                                          .allocationSize = wholePages(texels.bytes().size()),
                                                          .memoryTypeIndex = device.memoryType(types, {}, {})});
    image.texels = std::move(texels);
    complete(device, image, std::move(handle), Usage::eSampled, name);
    return image;
}

} // namespace torrance::gpu
