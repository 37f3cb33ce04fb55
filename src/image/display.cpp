#include "image/display.h"

#include "core/parallel.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace torrance {
namespace {

vec3 displayColor(vec3 color, float scale, const DisplaySettings& settings)
{
    const vec3 toned = settings.tone->single(color * scale);
    const auto encode = settings.transfer->single;
    return {encode(toned.x), encode(toned.y), encode(toned.z)};
}

} // namespace

float exposureGain(const DisplaySettings& settings)
{
    return static_cast<float>(std::exp2(settings.exposure));
}

bool keepsCoverage(const Image& sceneLinear, const DisplaySettings& settings)
{
    assert(sceneLinear.channels == 3 || sceneLinear.channels == 4);
    return sceneLinear.channels == 4 && settings.alpha == AlphaRule::straight;
}

void displayRow(const Image& sceneLinear, int y, const DisplaySettings& settings, float* encoded)
{
    const float gain = exposureGain(settings);
    const bool keepsAlpha = keepsCoverage(sceneLinear, settings);
    for (int x = 0; x < sceneLinear.width; ++x) {
        const float* in = sceneLinear.at(x, y);
        const float scale = keepsAlpha ? coverageScale(in[3]) : 1.0f;
        const vec3 color = displayColor({in[0], in[1], in[2]}, gain * scale, settings);
        encoded = std::copy_n(&color.x, 3, encoded);
        if (keepsAlpha)
            *encoded++ = in[3] > 0.0f ? std::min(in[3], 1.0f) : 0.0f;
    }
}

Image toDisplay(const Image& sceneLinear, const DisplaySettings& settings)
{
    Image encoded(sceneLinear.width, sceneLinear.height, keepsCoverage(sceneLinear, settings) ? 4 : 3);
    parallelFor(static_cast<std::size_t>(sceneLinear.height), 16, [&](std::size_t y) {
        const int row = static_cast<int>(y);
        displayRow(sceneLinear, row, settings, encoded.at(0, row));
    });
    return encoded;
}

} // namespace torrance
