#include "image/display.h"

#include "core/parallel.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace torrance {
namespace {

// Additive light (glare over nothing) has coverage 0 and colour: it cannot be told in straight alpha, and is dropped
// with it.
float coverageScale(float alpha)
{
    return alpha > 0.0f ? 1.0f / std::min(alpha, 1.0f) : 0.0f;
}

vec3 displayColor(vec3 color, float scale, const DisplaySettings& settings)
{
    const vec3 toned = settings.tone->single(color * scale);
    const auto encode = settings.transfer->single;
    return {encode(toned.x), encode(toned.y), encode(toned.z)};
}

void convertRow(const Image& from, Image& to, int y, const DisplaySettings& settings)
{
    const auto gain = static_cast<float>(std::exp2(settings.exposure));
    for (int x = 0; x < from.width; ++x) {
        const float* in = from.at(x, y);
        float* out = to.at(x, y);
        const float scale = to.channels == 4 ? coverageScale(in[3]) : 1.0f;
        const vec3 color = displayColor({in[0], in[1], in[2]}, gain * scale, settings);
        std::copy_n(&color.x, 3, out);
        if (to.channels == 4)
            out[3] = in[3] > 0.0f ? std::min(in[3], 1.0f) : 0.0f;
    }
}

} // namespace

Image toDisplay(const Image& sceneLinear, const DisplaySettings& settings)
{
    assert(sceneLinear.channels == 3 || sceneLinear.channels == 4);
    const bool keepsAlpha = sceneLinear.channels == 4 && settings.alpha == AlphaRule::straight;
    Image encoded(sceneLinear.width, sceneLinear.height, keepsAlpha ? 4 : 3);
    parallelFor(static_cast<std::size_t>(sceneLinear.height), 16,
                [&](std::size_t y) { convertRow(sceneLinear, encoded, static_cast<int>(y), settings); });
    return encoded;
}

} // namespace torrance
