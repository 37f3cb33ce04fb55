// Separate maps as the textures of a glTF material.
#pragma once

#include "files/channel_pack.h"

namespace torrance {

/// One channel of a picture, or nothing.
struct MapChannel
{
    const TextureImage* image = nullptr;
    Channel channel = Channel::luminance;
    std::function<double(double)> change = {};
};

/// Colour (sRGB) with opacity in its alpha; white where there is no colour. `opacity` has an image.
TextureImage packColorOpacity(const TextureImage* color, const MapChannel& opacity, Wrap wrap);

/// Green roughness, blue metallic; 1 where one of them has no image. At least one has.
TextureImage packMetallicRoughness(const MapChannel& roughness, const MapChannel& metallic, Wrap wrap);

/// Alpha is 0 or 1 everywhere: the surface is cut out, not blended.
bool isCutOut(const TextureImage& image);

/// The channel that holds opacity: alpha where a texel's is not 1, luminance otherwise.
Channel opacityChannel(const TextureImage& image);

/// Of different proportions, so that they cannot lie in one picture.
bool differInProportions(const TextureImage& a, const TextureImage& b);

/// "3x1 and 2x1"
std::string sizesText(const TextureImage& a, const TextureImage& b);

} // namespace torrance
