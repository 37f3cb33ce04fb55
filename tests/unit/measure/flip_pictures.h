// Pictures for the tests of FLIP, made by exact arithmetic so that another program can make the same ones.
#pragma once

#include "image/image.h"

namespace torrance::test {

inline constexpr int kFlipWidth = 64, kFlipHeight = 48;

/// Colour ramps with a checker of 8 pixels and a line.
inline Image flipReference()
{
    Image image(kFlipWidth, kFlipHeight, 3);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            float* texel = image.at(x, y);
            const bool light = ((x / 8 + y / 8) & 1) != 0;
            texel[0] = static_cast<float>(x) / 64.0f;
            texel[1] = light ? 0.75f : 0.25f;
            texel[2] = static_cast<float>(y) / 64.0f;
            if (x == 40)
                texel[0] = texel[1] = texel[2] = 1.0f;
        }
    return image;
}

/// The same with the line one pixel further, a tint in one quarter and specks.
inline Image flipTest()
{
    Image image = flipReference();
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            float* texel = image.at(x, y);
            if (x == 40)
                for (int channel = 0; channel < 3; ++channel)
                    texel[channel] = image.at(x - 1, y)[channel];
            if (x == 41)
                texel[0] = texel[1] = texel[2] = 1.0f;
            if (x < 24 && y < 20)
                texel[2] = texel[2] * 0.5f + 0.25f;
            if ((x * 7 + y * 13) % 101 == 0)
                texel[0] = 1.0f - texel[0];
        }
    return image;
}

/// The same pictures over a range of 2^13: columns of eight pixels are a stop and a half apart.
inline Image flipHighRange(Image image)
{
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const int half = 3 * (x / 8); // in half stops
            const float gain = static_cast<float>(1 << (half / 2)) * (half % 2 != 0 ? 1.5f : 1.0f);
            for (int channel = 0; channel < 3; ++channel)
                image.at(x, y)[channel] = (image.at(x, y)[channel] + 0.0625f) * gain / 64.0f;
        }
    return image;
}

} // namespace torrance::test
