// Images on the device, filled piece by piece: what is uploaded needs no second copy on the host.
#pragma once

#include "gpu/image.h"

#include <cstddef>
#include <functional>
#include <span>

namespace torrance {

/// Texels, tightly packed, in the order mip-major: all layers of mip 0, then mip 1 ... `next` writes the bytes that
/// follow those of the call before, or returns false to give up, which fillImage then returns. The image is left
/// `sampled`.
bool fillImage(const gpu::Device& device, const gpu::DeviceImage& image, std::size_t bytesPerTexel,
               const std::function<bool(std::span<std::byte>)>& next);

} // namespace torrance
