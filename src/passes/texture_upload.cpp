#include "passes/texture_upload.h"

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "image/srgb.h"
#include "math/half.h"
#include "passes/sampler.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <set>

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

} // namespace

TexelContent contentOf(std::size_t slot)
{
    constexpr std::array kContents = {TexelContent::color, TexelContent::data, TexelContent::normal, TexelContent::data,
                                      TexelContent::color};
    return kContents[slot];
}

Textures::Textures(const gpu::Device& device, const Scene& scene, const ShadingPlan& plan)
{
    // N samples a pixel: each stands for 1/N of its area, so the level may be finer by half a step per doubling.
    const float lodBias = -0.5f * std::log2(static_cast<float>(plan.settings.samples));
    struct Need
    {
        bool mips = false;
        bool alphaMatters = false;
    };
    std::map<std::pair<int, TexelContent>, Need> needs;
    for (const Texture& texture : scene.textures) {
        imageOf.push_back(texture.image);
        samplers.emplace_back(nullptr);
    }
    for (const auto* list : {&plan.batches, &plan.blended})
        for (const Batch& batch : *list)
            for (std::size_t slot = 0; slot < batch.textures.size(); ++slot) {
                if (batch.textures[slot] < 0)
                    continue;
                const auto index = static_cast<std::size_t>(batch.textures[slot]);
                const Texture& texture = scene.textures[index];
                Need& need = needs[{texture.image, contentOf(slot)}];
                need.mips |= texture.sampler.mip != MipFilter::none;
                need.alphaMatters |= slot == 0 && batch.key.alphaMode != AlphaMode::opaque;
                if (!*samplers[index])
                    samplers[index] = makeSampler(device, texture.sampler, lodBias);
            }
    const bool lengths = plan.settings.methods.specularAntialiasing->id == "toksvig";
    for (const auto& [use, need] : needs) {
        const TextureImage& source = scene.images[static_cast<std::size_t>(use.first)];
        if (lengths && use.second == TexelContent::normal)
            images.emplace(use, upload(device, source,
                                       makeTexels(wideNormals(source), {.content = use.second, .lengthInAlpha = true},
                                                  need.mips)));
        else
            images.emplace(
                use, upload(device, source,
                            makeTexels(source, {.content = use.second, .weighByAlpha = need.alphaMatters}, need.mips)));
    }
}

const gpu::DeviceImage& Textures::image(int texture, TexelContent content) const
{
    return images.at({imageOf[static_cast<std::size_t>(texture)], content});
}

const vk::raii::Sampler& Textures::sampler(int texture) const
{
    return samplers[static_cast<std::size_t>(texture)];
}

std::vector<gpu::ImageUse> Textures::uses() const
{
    std::vector<gpu::ImageUse> list;
    for (const auto& [use, image] : images)
        list.push_back(gpu::use(image, gpu::Access::sampled));
    return list;
}

} // namespace torrance
