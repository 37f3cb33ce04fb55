// Normal maps made from height maps.
#pragma once

#include "files/channel_pack.h"

namespace torrance {

/// The tangent-space normal map, in 16 bits, of a surface whose white texels stand `height` texels above its black
/// ones: central differences of a channel, wrapped or clamped at the edges. +X is u, +Y is up in the picture, as glTF
/// has it.
TextureImage normalsOfHeights(const TextureImage& heights, Channel channel, double height, Wrap wrap);

} // namespace torrance
