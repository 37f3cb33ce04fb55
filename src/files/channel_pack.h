// Channels of several pictures put together into one, as glTF's textures want them.
#pragma once

#include "scene/texture.h"

#include <array>
#include <functional>
#include <string>

namespace torrance {

enum class Channel
{
    red,
    green,
    blue,
    alpha,
    luminance, // Rec. 709 weights on the stored values: exactly the value of a grey texel
};

/// Where one channel of the result comes from.
struct PackedChannel
{
    const TextureImage* image = nullptr; // null: `constant` everywhere
    Channel channel = Channel::red;
    double constant = 1.0;                     // 0 to 1
    std::function<double(double)> change = {}; // of every value, 0 to 1 to 0 to 1
    bool srgb = false;                         // enlarged in linear light
    bool inverted = false;                     // 1 - value: of a code, exactly the code as far from the other end
};

/// The picture is as wide as the widest source and as high as the highest; smaller ones are enlarged, filtered as a
/// sampler filters: linearly between the middles of texels, wrapped or clamped at the edges. 16 bits where a source
/// has them, is enlarged or changed, so that nothing is rounded to 8 bits here; otherwise the codes stay what they
/// are.
TextureImage packChannels(const std::string& name, const std::array<PackedChannel, 4>& channels, Wrap wrap);

/// Some texel's alpha is not 1.
bool hasAlpha(const TextureImage& image);

/// Every texel's red, green and blue agree.
bool isGrey(const TextureImage& image);

/// 0 to 1: the stored value, whatever its bits.
double texelValue(const TextureImage& image, int x, int y, Channel channel);

/// Stores four values of 0 to 1, rounded to the image's codes.
void storeTexel(TextureImage& image, int x, int y, const std::array<double, 4>& values);

} // namespace torrance
