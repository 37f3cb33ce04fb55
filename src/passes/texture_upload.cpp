#include "passes/texture_upload.h"

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "passes/sampler.h"
#include "prepare/texture_levels.h"

#include <algorithm>
#include <array>
#include <cmath>

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

vk::Format formatOf(TexelStorage storage)
{
    constexpr std::array kFormats = {vk::Format::eR8G8B8A8Unorm, vk::Format::eR16G16B16A16Unorm,
                                     vk::Format::eR16G16B16A16Sfloat, vk::Format::eR32G32B32A32Sfloat};
    return kFormats[static_cast<std::size_t>(storage)];
}

Texels makeTexels(const TextureImage& image, const MipRule& rule, bool mips)
{
    const TexelStorage storage = storageOf(image.format, rule);
    Texels texels = {.format = formatOf(storage),
                     .bytesPerTexel = bytesPerTexel(storage),
                     .mips = mips ? static_cast<std::uint32_t>(mipCount(image.width, image.height)) : 1,
                     .bytes = {}};
    std::vector<std::size_t> offsets, pitches;
    std::size_t size = 0;
    for (std::uint32_t level = 0; level < texels.mips; ++level) {
        pitches.push_back(static_cast<std::size_t>(std::max(1, image.width >> level)) * texels.bytesPerTexel);
        offsets.push_back(size);
        size += pitches.back() * static_cast<std::size_t>(std::max(1, image.height >> level));
    }
    texels.bytes.resize(size);
    std::vector<LevelMemory> levels;
    for (std::size_t level = 0; level < offsets.size(); ++level)
        levels.push_back({texels.bytes.data() + offsets[level], pitches[level]});
    writeLevels(image, rule, levels);
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
        const MipRule rule = {.content = use.second,
                              .weighByAlpha = need.alphaMatters && use.second == TexelContent::color,
                              .lengthInAlpha = lengths && use.second == TexelContent::normal};
        images.emplace(use, upload(device, source, makeTexels(source, rule, need.mips)));
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
