#include "files/material_maps.h"

namespace torrance {

TextureImage packColorOpacity(const TextureImage* color, const MapChannel& opacity, Wrap wrap)
{
    PackedChannel red{color, Channel::red, 1.0, {}, true}, green = red, blue = red;
    green.channel = Channel::green;
    blue.channel = Channel::blue;
    return packChannels((color == nullptr ? *opacity.image : *color).name,
                        {red, green, blue, {opacity.image, opacity.channel, 1.0, opacity.change}}, wrap);
}

TextureImage packMetallicRoughness(const MapChannel& roughness, const MapChannel& metallic, Wrap wrap)
{
    return packChannels((roughness.image != nullptr ? *roughness.image : *metallic.image).name,
                        {PackedChannel{},
                         {roughness.image, roughness.channel, 1.0, roughness.change},
                         {metallic.image, metallic.channel, 1.0, metallic.change},
                         PackedChannel{}},
                        wrap);
}

bool isCutOut(const TextureImage& image)
{
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (const double alpha = texelValue(image, x, y, Channel::alpha); alpha > 0.0 && alpha < 1.0)
                return false;
    return true;
}

Channel opacityChannel(const TextureImage& image)
{
    return hasAlpha(image) ? Channel::alpha : Channel::luminance;
}

bool differInProportions(const TextureImage& a, const TextureImage& b)
{
    return static_cast<long long>(a.width) * b.height != static_cast<long long>(b.width) * a.height;
}

std::string sizesText(const TextureImage& a, const TextureImage& b)
{
    const auto size = [](const TextureImage& i) { return std::to_string(i.width) + "x" + std::to_string(i.height); };
    return size(a) + " and " + size(b);
}

} // namespace torrance
