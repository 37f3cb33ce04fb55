#include "gpu/unread_channels.h"

#include <algorithm>

namespace torrance::gpu {

void leaveOutUnread(const Device& device, DeviceImage& image, const std::array<bool, 4>& read, std::string_view name)
{
    if (std::ranges::all_of(read, [](bool is) { return is; }))
        return;
    const auto component = [&](std::size_t c) {
        return read[c] ? vk::ComponentSwizzle::eIdentity : vk::ComponentSwizzle::eOne;
    };
    image.view = vk::raii::ImageView(device.handle,
                                     {.image = *image.handle,
                                      .viewType = image.shape.cube ? vk::ImageViewType::eCube : vk::ImageViewType::e2D,
                                      .format = image.shape.format,
                                      .components = {component(0), component(1), component(2), component(3)},
                                      .subresourceRange = {.aspectMask = image.aspect(),
                                                           .levelCount = image.shape.mips,
                                                           .layerCount = image.shape.layers}});
    device.name(image.view, name);
}

} // namespace torrance::gpu
