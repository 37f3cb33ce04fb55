#include "passes/texture_upload.h"

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/unread_channels.h"
#include "passes/sampler.h"
#include "plan/level_plan.h"
#include "prepare/texture_levels.h"

#include <algorithm>
#include <array>

namespace torrance {
namespace {

vk::Format formatOf(TexelStorage storage)
{
    constexpr std::array kFormats = {vk::Format::eR8G8B8A8Unorm, vk::Format::eR16G16B16A16Unorm,
                                     vk::Format::eR16G16B16A16Sfloat, vk::Format::eR32G32B32A32Sfloat};
    return kFormats[static_cast<std::size_t>(storage)];
}

using WriteLevels = std::function<void(std::span<const LevelMemory>)>;

// `missing` levels before those of the image are no one's.
void writeInPlace(const gpu::DeviceImage& image, std::size_t missing, const WriteLevels& write)
{
    std::vector<LevelMemory> levels(missing);
    gpu::writeRows(image, [&](std::span<const gpu::LevelRows> rows) {
        for (const gpu::LevelRows& level : rows)
            levels.push_back({level.texels, level.rowPitch});
        write(levels);
    });
}

void copyOver(const gpu::Device& device, const gpu::DeviceImage& image, std::size_t missing, std::size_t texelBytes,
              const WriteLevels& write)
{
    std::vector<std::size_t> offsets, pitches;
    std::size_t size = 0;
    for (std::uint32_t level = 0; level < image.shape.mips; ++level) {
        pitches.push_back(std::max<std::size_t>(1, image.shape.width >> level) * texelBytes);
        offsets.push_back(size);
        size += pitches.back() * std::max<std::size_t>(1, image.shape.height >> level);
    }
    const gpu::Buffer staging = gpu::makeStagingBuffer(device, size, "texels");
    std::vector<LevelMemory> levels(missing);
    for (std::size_t level = 0; level < offsets.size(); ++level)
        levels.push_back({staging.mapped + offsets[level], pitches[level]});
    write(levels);
    gpu::Commands commands(device);
    gpu::copyToImage(commands, staging, image, texelBytes);
    commands.submitAndWait();
}

ChannelPictures picturesOf(const Scene& scene, const PlannedTexture& texture)
{
    ChannelPictures pictures;
    for (std::size_t c = 0; c < texture.channels.size(); ++c) {
        const ChannelSource& source = texture.channels[c];
        pictures.images[c] = source.image < 0 ? nullptr : &scene.images[static_cast<std::size_t>(source.image)];
        pictures.channels[c] = source.channel;
    }
    return pictures;
}

/// The texture is a picture as it is, or as much of it as anything reads.
bool isOnePicture(const ChannelPictures& pictures)
{
    for (std::size_t c = 0; c < pictures.images.size(); ++c)
        if (pictures.images[c] && (pictures.images[c] != &pictures.any() || pictures.channels[c] != int(c)))
            return false;
    return true;
}

std::array<bool, 4> channelsRead(const PlannedTexture& texture)
{
    std::array<bool, 4> read{};
    for (std::size_t c = 0; c < read.size(); ++c)
        read[c] = texture.channels[c].image >= 0;
    read[3] = read[3] || texture.lengthInAlpha;
    return read;
}

bool hasTexels(const ChannelPictures& pictures)
{
    return std::ranges::none_of(pictures.images,
                                [](const TextureImage* picture) { return picture && picture->texels.empty(); });
}

/// What is to be kept of a texture that was made, read where its image has it.
struct KeepTask
{
    ContentHash key;
    PlannedTexture texture;
    std::size_t texelBytes;
    std::vector<LevelMemory> levels;
};

struct MadeTexture
{
    gpu::DeviceImage image;
    std::optional<KeepTask> keep;
};

MadeTexture makeTexture(const gpu::Device& device, const Scene& scene, const PlannedTexture& texture, int finestLevel,
                        const KeptLevels& kept)
{
    const ChannelPictures pictures = picturesOf(scene, texture);
    const TextureImage& picture = pictures.any();
    const MipRule rule = {
        .content = texture.content, .weighByAlpha = texture.weighByAlpha, .lengthInAlpha = texture.lengthInAlpha};
    const TexelStorage storage = storageOf(pictures.format(), rule);
    const bool mips = texture.sampler.mip != MipFilter::none;
    const int levelCount = mips ? mipCount(picture.width, picture.height) : 1;
    const gpu::ImageShape shape = {.width = static_cast<std::uint32_t>(std::max(1, picture.width >> finestLevel)),
                                   .height = static_cast<std::uint32_t>(std::max(1, picture.height >> finestLevel)),
                                   .mips = static_cast<std::uint32_t>(levelCount - finestLevel),
                                   .format = formatOf(storage)};
    const auto missing = static_cast<std::size_t>(finestLevel);
    const auto key = kept.textures ? levelsKey(texture, kept.encoded, finestLevel) : std::nullopt;
    const std::size_t texelBytes = bytesPerTexel(storage);
    const bool inPlace = gpu::canSampleRows(device, shape);
    using Usage = vk::ImageUsageFlagBits;
    MadeTexture result = {
        .image = gpu::makeImage(device, shape,
                                inPlace ? vk::ImageUsageFlags(Usage::eSampled) : Usage::eSampled | Usage::eTransferDst,
                                picture.name, inPlace ? gpu::ImageTiling::rows : gpu::ImageTiling::device),
        .keep = std::nullopt};
    const WriteLevels write = [&](std::span<const LevelMemory> levels) {
        if (key && kept.textures->readLevels(*key, texture, texelBytes, levels))
            return;
        if (!hasTexels(pictures))
            throw TexelsMissing();
        isOnePicture(pictures) ? writeLevels(picture, rule, levels) : writePackedLevels(pictures, rule, levels);
        if (key && inPlace)
            result.keep = KeepTask{*key, texture, texelBytes, {levels.begin(), levels.end()}};
        else if (key) // what is copied from goes with the copy
            kept.textures->keepLevels(*key, texture, texelBytes, levels);
    };
    inPlace ? writeInPlace(result.image, missing, write) : copyOver(device, result.image, missing, texelBytes, write);
    return result;
}

// By Scene::images: one more than the number of the last texture that reads it; 0 where none does.
std::vector<std::size_t> lastReaders(const Scene& scene, const ShadingPlan& plan)
{
    std::vector<std::size_t> readers(scene.images.size(), 0);
    for (std::size_t i = 0; i < plan.textures.size(); ++i)
        for (const ChannelSource& source : plan.textures[i].channels)
            if (source.image >= 0)
                readers[static_cast<std::size_t>(source.image)] = i + 1;
    return readers;
}

} // namespace

Textures::Textures(const gpu::Device& device, const Scene& scene, const ShadingPlan& plan,
                   std::span<const int> finestLevels, const TexelsRead& texelsRead, const KeptLevels& kept)
{
    const std::vector<std::size_t> readers = lastReaders(scene, plan);
    const auto tellRead = [&](std::size_t texturesMade) {
        for (std::size_t image = 0; texelsRead && image < readers.size(); ++image)
            if (readers[image] == texturesMade)
                texelsRead(static_cast<int>(image));
    };
    tellRead(0);
    std::vector<KeepTask> tasks;
    const auto lodBias = static_cast<float>(levelBias(plan.settings));
    for (std::size_t i = 0; i < plan.textures.size(); ++i) {
        const PlannedTexture& texture = plan.textures[i];
        MadeTexture made = makeTexture(device, scene, texture, finestLevels[i], kept);
        images.push_back(std::move(made.image));
        if (made.keep)
            tasks.push_back(std::move(*made.keep));
        gpu::leaveOutUnread(device, images.back(), channelsRead(texture), "texture");
        if (!samplers.contains(texture.sampler))
            samplers.emplace(texture.sampler, makeSampler(device, texture.sampler, lodBias));
        samplerOf.push_back(texture.sampler);
        tellRead(i + 1);
    }
    gpu::Commands commands(device);
    commands.use(uses());
    commands.submitAndWait();
    if (!tasks.empty()) // while the picture is drawn: nobody waits for a disk
        keeping = std::async(std::launch::async, [store = kept.textures, tasks = std::move(tasks)] {
            for (const KeepTask& task : tasks)
                store->keepLevels(task.key, task.texture, task.texelBytes, task.levels);
        });
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

bool makesSameTextures(const ShadingPlan& a, const ShadingPlan& b)
{
    return a.textures == b.textures && levelBias(a.settings) == levelBias(b.settings);
}

} // namespace torrance
