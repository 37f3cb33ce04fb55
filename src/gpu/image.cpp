#include "gpu/image.h"

#include "core/error.h"

namespace torrance::gpu {

bool isDepthFormat(vk::Format format)
{
    return format == vk::Format::eD32Sfloat;
}

vk::ImageAspectFlags DeviceImage::aspect() const
{
    return isDepthFormat(shape.format) ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
}

DeviceImage makeImage(const Device& device, const ImageShape& shape, vk::ImageUsageFlags usage, std::string_view name)
{
    if (const std::uint32_t limit = device.limits.maxImageDimension2D; shape.width > limit || shape.height > limit)
        throw usageError(std::to_string(shape.width) + "x" + std::to_string(shape.height) + " is more than " +
                             device.description.name + " can hold (" + std::to_string(limit) + " a side)",
                         "choose a smaller size");
    const vk::ImageCreateInfo info = {.flags = shape.cube ? vk::ImageCreateFlagBits::eCubeCompatible
                                                          : vk::ImageCreateFlags{},
                                      .imageType = vk::ImageType::e2D,
                                      .format = shape.format,
                                      .extent = {shape.width, shape.height, 1},
                                      .mipLevels = shape.mips,
                                      .arrayLayers = shape.layers,
                                      .samples = vk::SampleCountFlagBits::e1,
                                      .tiling = vk::ImageTiling::eOptimal,
                                      .usage = usage};
    DeviceImage image;
    image.shape = shape;
    vk::raii::Image handle(device.handle, info);
    const vk::MemoryRequirements needs = handle.getMemoryRequirements();
    const std::uint32_t type = device.memoryType(needs.memoryTypeBits, {}, vk::MemoryPropertyFlagBits::eDeviceLocal);
    image.memory = vk::raii::DeviceMemory(device.handle, {.allocationSize = needs.size, .memoryTypeIndex = type});
    image.handle = std::move(handle);
    image.handle.bindMemory(*image.memory, 0);
    image.view = vk::raii::ImageView(
        device.handle,
        {.image = *image.handle,
         .viewType = shape.cube ? vk::ImageViewType::eCube : vk::ImageViewType::e2D,
         .format = shape.format,
         .subresourceRange = {.aspectMask = image.aspect(), .levelCount = shape.mips, .layerCount = shape.layers}});
    device.name(image.memory, name);
    device.name(image.handle, name);
    device.name(image.view, name);
    return image;
}

} // namespace torrance::gpu
