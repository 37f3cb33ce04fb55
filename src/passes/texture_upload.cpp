#include "passes/texture_upload.h"

#include "core/parallel.h"
#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "image/srgb.h"
#include "math/half.h"
#include "passes/sampler.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace torrance {
namespace {

// A texture as the device gets it: mips from large to small, tightly packed.
struct Texels
{
    vk::Format format;
    std::size_t bytesPerTexel;
    std::uint32_t mips;
    std::vector<std::byte> bytes;
};

// There is no 16-bit sRGB format: the curve is undone here, in float, so that filtering happens in linear light.
void appendDecodedWide(std::vector<std::byte>& bytes, const TextureImage& level)
{
    std::vector<float> linear(level.texels.size() / sizeof(std::uint16_t));
    for (std::size_t i = 0; i < linear.size(); ++i) {
        std::uint16_t stored;
        std::memcpy(&stored, level.texels.data() + i * sizeof stored, sizeof stored);
        const double value = stored / 65535.0;
        linear[i] = static_cast<float>(i % 4 == 3 ? value : srgbDecode(value));
    }
    const auto view = std::as_bytes(std::span(linear));
    bytes.insert(bytes.end(), view.begin(), view.end());
}

using HalfTable = std::array<std::uint16_t, 256>;

template <typename Decode>
HalfTable halfTable(const Decode& decode)
{
    HalfTable table;
    for (std::size_t code = 0; code < table.size(); ++code)
        table[code] = toHalf(static_cast<float>(decode(static_cast<double>(code) / 255.0)));
    return table;
}

// 8-bit colours become linear halves, within 2^-12 of the exact curve: lavapipe's own decoding of an sRGB format is a
// polynomial, off by 1e-3 in the middle of the curve and by 1e-2 in the dark (tests/image/surfaces.cpp). As fast to
// sample as an sRGB format, at twice the memory.
void appendDecoded(std::vector<std::byte>& bytes, const TextureImage& level)
{
    static const HalfTable colors = halfTable([](double v) { return srgbDecode(v); });
    static const HalfTable alphas = halfTable([](double v) { return v; });
    std::vector<std::uint16_t> linear(level.texels.size());
    for (std::size_t i = 0; i < linear.size(); ++i)
        linear[i] = (i % 4 == 3 ? alphas : colors)[static_cast<std::size_t>(level.texels[i])];
    const auto view = std::as_bytes(std::span(linear));
    bytes.insert(bytes.end(), view.begin(), view.end());
}

void appendStored(std::vector<std::byte>& bytes, const TextureImage& level)
{
    bytes.insert(bytes.end(), level.texels.begin(), level.texels.end());
}

// How a kind of texture lies on the device.
struct Storage
{
    vk::Format format;
    std::size_t bytesPerTexel;
    void (*append)(std::vector<std::byte>&, const TextureImage&);
};

Storage storageOf(TexelFormat format, TexelContent content)
{
    const bool wide = format == TexelFormat::rgba16;
    if (content == TexelContent::color)
        return wide ? Storage{vk::Format::eR32G32B32A32Sfloat, 16, appendDecodedWide}
                    : Storage{vk::Format::eR16G16B16A16Sfloat, 8, appendDecoded};
    return {wide ? vk::Format::eR16G16B16A16Unorm : vk::Format::eR8G8B8A8Unorm, bytesPerTexel(format), appendStored};
}

Texels makeTexels(const TextureImage& image, const MipRule& rule, bool mips)
{
    std::vector<TextureImage> levels;
    if (mips)
        levels = makeMips(image, rule);
    const Storage storage = storageOf(image.format, rule.content);
    Texels texels = {.format = storage.format,
                     .bytesPerTexel = storage.bytesPerTexel,
                     .mips = static_cast<std::uint32_t>(1 + levels.size()),
                     .bytes = {}};
    storage.append(texels.bytes, image);
    for (const TextureImage& level : levels)
        storage.append(texels.bytes, level);
    return texels;
}

gpu::DeviceImage upload(const gpu::Device& device, const TextureImage& source, const Texels& texels)
{
    using Usage = vk::ImageUsageFlagBits;
    gpu::DeviceImage image = gpu::makeImage(device,
                                            {.width = static_cast<std::uint32_t>(source.width),
                                             .height = static_cast<std::uint32_t>(source.height),
                                             .mips = texels.mips,
                                             .format = texels.format},
                                            Usage::eSampled | Usage::eTransferDst, source.name);
    const gpu::Buffer staging = gpu::makeBuffer(device, texels.bytes, vk::BufferUsageFlagBits::eTransferSrc, "texels");
    gpu::Commands commands(device);
    gpu::copyToImage(commands, staging, image, texels.bytesPerTexel);
    commands.submitAndWait();
    return image;
}

bool isWhole(const PlannedTexture& texture)
{
    for (std::size_t c = 0; c < texture.channels.size(); ++c) {
        const ChannelSource& source = texture.channels[c];
        if (source.image >= 0 && (source.image != texture.channels.front().image || source.channel != int(c)))
            return false;
    }
    return texture.channels.front().image >= 0;
}

const TextureImage& anyImage(const Scene& scene, const PlannedTexture& texture)
{
    const auto source = std::ranges::find_if(texture.channels, [](const ChannelSource& c) { return c.image >= 0; });
    return scene.images[static_cast<std::size_t>(source->image)];
}

// The code of a texel's channel, widened to 16 bits where the texture has 16: k * 257 is the same fraction.
std::uint16_t codeOf(const TextureImage& image, std::size_t texel, int channel, bool wide)
{
    const std::byte* at = image.texels.data() + texel * bytesPerTexel(image.format);
    if (image.format == TexelFormat::rgba8)
        return static_cast<std::uint16_t>(std::to_integer<unsigned>(at[channel]) * (wide ? 257u : 1u));
    std::uint16_t code;
    std::memcpy(&code, at + 2 * channel, sizeof code);
    return code;
}

// Channels of several images of one size as one. What nothing reads is 1.
TextureImage packed(const Scene& scene, const PlannedTexture& texture)
{
    const TextureImage& first = anyImage(scene, texture);
    const bool wide = std::ranges::any_of(texture.channels, [&](const ChannelSource& c) {
        return c.image >= 0 && scene.images[static_cast<std::size_t>(c.image)].format == TexelFormat::rgba16;
    });
    TextureImage result{first.name, first.width, first.height, wide ? TexelFormat::rgba16 : TexelFormat::rgba8, {}};
    const std::size_t bytes = bytesPerTexel(result.format),
                      count = static_cast<std::size_t>(first.width) * static_cast<std::size_t>(first.height);
    result.texels.resize(count * bytes, std::byte(0xff));
    constexpr std::size_t kTexelsPerTask = 1 << 16;
    parallelFor(count, kTexelsPerTask, [&](std::size_t i) {
        for (std::size_t c = 0; c < texture.channels.size(); ++c) {
            const ChannelSource& source = texture.channels[c];
            if (source.image < 0)
                continue;
            const std::uint16_t code =
                codeOf(scene.images[static_cast<std::size_t>(source.image)], i, source.channel, wide);
            std::memcpy(result.texels.data() + i * bytes + c * bytes / 4, &code, bytes / 4); // little-endian
        }
    });
    return result;
}

} // namespace

Textures::Textures(const gpu::Device& device, const Scene& scene, const ShadingPlan& plan)
{
    // N samples a pixel: each stands for 1/N of its area, so the level may be finer by half a step per doubling.
    const float lodBias = -0.5f * std::log2(static_cast<float>(plan.settings.samples));
    for (const PlannedTexture& texture : plan.textures) {
        const bool mips = texture.sampler.mip != MipFilter::none;
        const MipRule rule = {
            .content = texture.content, .weighByAlpha = texture.weighByAlpha, .lengthInAlpha = texture.lengthInAlpha};
        const auto make = [&](const TextureImage& source) {
            images.push_back(upload(device, source, makeTexels(source, rule, mips)));
        };
        if (texture.lengthInAlpha)
            make(wideNormals(anyImage(scene, texture)));
        else if (isWhole(texture))
            make(anyImage(scene, texture));
        else
            make(packed(scene, texture));
        if (!samplers.contains(texture.sampler))
            samplers.emplace(texture.sampler, makeSampler(device, texture.sampler, lodBias));
        samplerOf.push_back(texture.sampler);
    }
}

const gpu::DeviceImage& Textures::image(int texture) const
{
    return images[static_cast<std::size_t>(texture)];
}

const vk::raii::Sampler& Textures::sampler(int texture) const
{
    return samplers.at(samplerOf[static_cast<std::size_t>(texture)]);
}

std::vector<gpu::ImageUse> Textures::uses() const
{
    std::vector<gpu::ImageUse> list;
    for (const gpu::DeviceImage& image : images)
        list.push_back(gpu::use(image, gpu::Access::sampled));
    return list;
}

} // namespace torrance
