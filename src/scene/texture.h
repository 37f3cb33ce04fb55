// What a material samples: stored texels and how they are addressed and filtered.
#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

namespace torrance {

enum class TexelFormat
{
    rgba8,  // four unsigned normalised 8-bit channels
    rgba16, // four unsigned normalised 16-bit channels, native byte order
};

constexpr std::size_t bytesPerTexel(TexelFormat format)
{
    return format == TexelFormat::rgba8 ? 4 : 8;
}

/// What texels mean, which decides how they are averaged and filtered.
enum class TexelContent
{
    color,  // sRGB-encoded colour, linear alpha: averaged as light
    data,   // linear values: roughness, metallic, occlusion, masks
    normal, // unit vectors, (c * 2 - 1) of each channel: the average direction, unit again
};

/// Texels as the file holds them (not decoded from sRGB): four channels, top row first. Missing channels are filled as
/// PNG and JPEG define it: grey to all three colours, alpha to one.
struct TextureImage
{
    std::string name; // for messages: the file's name for it, or "image 3"
    int width = 0;
    int height = 0;
    TexelFormat format = TexelFormat::rgba8;
    std::vector<std::byte> texels; // width * height * bytesPerTexel(format)
};

enum class Wrap
{
    repeat,
    mirroredRepeat,
    clampToEdge,
};

enum class Filter
{
    nearest,
    linear,
};

enum class MipFilter
{
    none, // level 0 only
    nearest,
    linear,
};

/// Defaults are glTF's recommendation where a file leaves the sampler out: repeat, trilinear.
struct Sampler
{
    Wrap wrapS = Wrap::repeat;
    Wrap wrapT = Wrap::repeat;
    Filter magnify = Filter::linear;
    Filter minify = Filter::linear;
    MipFilter mip = MipFilter::linear;

    auto operator<=>(const Sampler&) const = default;
};

struct Texture
{
    int image = -1; // Scene::images
    Sampler sampler;
};

} // namespace torrance
