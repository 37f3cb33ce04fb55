// Channels of an image that no shader reads.
#pragma once

#include "gpu/image.h"

#include <array>

namespace torrance::gpu {

/// Makes the image's view give 1 for the channels (r, g, b, a) that are not `read`, whatever they hold: a software
/// driver, which filters whole texels in code of its own for each texture, then leaves them out. For images of colours
/// that are sampled and not drawn into.
void leaveOutUnread(const Device& device, DeviceImage& image, const std::array<bool, 4>& read, std::string_view name);

} // namespace torrance::gpu
