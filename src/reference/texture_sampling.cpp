#include "reference/texture_sampling.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace torrance {
namespace {

/// IEC 61966-2-1, the exact curve.
double srgbToLinear(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// Of all codes of 8 bits: a mean over an area asks for thousands.
const std::array<double, 256>& linearOfCodes()
{
    static const std::array<double, 256> table = [] {
        std::array<double, 256> values{};
        for (std::size_t code = 0; code < values.size(); ++code)
            values[code] = srgbToLinear(double(code) / 255.0);
        return values;
    }();
    return table;
}

double channelAt(const TextureImage& image, std::size_t texel, int channel)
{
    const std::size_t index = texel * 4 + static_cast<std::size_t>(channel);
    if (image.format == TexelFormat::rgba8)
        return static_cast<double>(image.texels[index]) / 255.0;
    std::uint16_t value = 0;
    std::memcpy(&value, image.texels.data() + 2 * index, sizeof value);
    return value / 65535.0;
}

/// floor(u * size) without overflow: beyond 2^52 there is no fraction left and the texel is arbitrary but defined.
long long texelFloor(double u)
{
    constexpr double kExact = 4503599627370496.0; // 2^52
    return static_cast<long long>(std::floor(std::fmin(std::fmax(u, -kExact), kExact)));
}

dvec4 wrappedTexel(const TextureImage& image, const Sampler& sampler, long long x, long long y, ColorSpace space)
{
    return texelAt(image, wrapIndex(x, image.width, sampler.wrapS), wrapIndex(y, image.height, sampler.wrapT), space);
}

} // namespace

int wrapIndex(long long index, int size, Wrap wrap)
{
    const long long n = size;
    if (wrap == Wrap::clampToEdge)
        return static_cast<int>(index < 0 ? 0 : index >= n ? n - 1 : index);
    const long long period = wrap == Wrap::repeat ? n : 2 * n;
    const long long inPeriod = ((index % period) + period) % period;
    return static_cast<int>(inPeriod < n ? inPeriod : 2 * n - 1 - inPeriod);
}

dvec4 texelAt(const TextureImage& image, int x, int y, ColorSpace space)
{
    const std::size_t texel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
    dvec4 value;
    if (space == ColorSpace::srgb && image.format == TexelFormat::rgba8) {
        const std::byte* codes = image.texels.data() + 4 * texel;
        const auto& linear = linearOfCodes();
        return {linear[std::size_t(codes[0])], linear[std::size_t(codes[1])], linear[std::size_t(codes[2])],
                double(codes[3]) / 255.0};
    }
    for (int c = 0; c < 4; ++c) {
        const double stored = channelAt(image, texel, c);
        value[c] = space == ColorSpace::srgb && c < 3 ? srgbToLinear(stored) : stored;
    }
    return value;
}

dvec4 sampleImage(const TextureImage& image, const Sampler& sampler, const dvec2& uv, ColorSpace space)
{
    const dvec2 finite(std::isfinite(uv.x) ? uv.x : 0.0, std::isfinite(uv.y) ? uv.y : 0.0);
    const dvec2 place = finite * dvec2(image.width, image.height);
    if (sampler.magnify == Filter::nearest)
        return wrappedTexel(image, sampler, texelFloor(place.x), texelFloor(place.y), space);
    const long long x = texelFloor(place.x - 0.5);
    const long long y = texelFloor(place.y - 0.5);
    const double fx = place.x - 0.5 - static_cast<double>(x);
    const double fy = place.y - 0.5 - static_cast<double>(y);
    const dvec4 top =
        (1.0 - fx) * wrappedTexel(image, sampler, x, y, space) + fx * wrappedTexel(image, sampler, x + 1, y, space);
    const dvec4 bottom = (1.0 - fx) * wrappedTexel(image, sampler, x, y + 1, space) +
                         fx * wrappedTexel(image, sampler, x + 1, y + 1, space);
    return (1.0 - fy) * top + fy * bottom;
}

dvec2 usedUv(const TextureUse& use, const std::array<dvec2, 2>& uvs)
{
    return use.transform * dvec3(uvs[static_cast<std::size_t>(use.uvSet)], 1.0);
}

dvec4 sampleUse(const Scene& scene, const TextureUse& use, const std::array<dvec2, 2>& uvs, ColorSpace space)
{
    if (!use.used())
        return dvec4(1.0);
    const Texture& texture = scene.textures[static_cast<std::size_t>(use.texture)];
    return sampleImage(scene.images[static_cast<std::size_t>(texture.image)], texture.sampler, usedUv(use, uvs), space);
}

} // namespace torrance
