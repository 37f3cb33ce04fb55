#include "passes/texture_upload.h"

#include "core/parallel.h"
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
                                     vk::Format::eR16G16B16A16Sfloat, vk::Format::eR32G32B32A32Sfloat,
                                     vk::Format::eR32G32B32A32Uint};
    return kFormats[static_cast<std::size_t>(storage)];
}

/// Of what is no texel words the first alone.
WordPictures partsOf(const Scene& scene, const PlannedTexture& texture)
{
    WordPictures parts;
    const std::span<const ChannelSource> sources = sourcesOf(texture);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        ChannelPictures& pictures = parts[i / 4];
        pictures.images[i % 4] =
            sources[i].image < 0 ? nullptr : &scene.images[static_cast<std::size_t>(sources[i].image)];
        pictures.channels[i % 4] = sources[i].channel;
    }
    return parts;
}

const TextureImage& anyOf(const WordPictures& parts)
{
    return std::ranges::find_if(parts, [](const ChannelPictures& p) { return !p.empty(); })->any();
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
    if (texture.words)
        return {true, true, true, true};
    for (std::size_t c = 0; c < read.size(); ++c)
        read[c] = texture.channels[c].image >= 0;
    read[3] = read[3] || texture.lengthInAlpha;
    return read;
}

bool hasTexels(const WordPictures& parts)
{
    return std::ranges::none_of(parts, [](const ChannelPictures& pictures) {
        return std::ranges::any_of(pictures.images,
                                   [](const TextureImage* picture) { return picture && picture->texels.empty(); });
    });
}

/// A texture as its image is to have it.
struct TextureTask
{
    const PlannedTexture& texture;
    WordPictures pictures;
    MipRule rule = {};
    std::size_t texelBytes = 0;
    std::size_t missing = 0; // levels that are no one's, before those of the image
    gpu::ImageShape shape = {};
    bool inPlace = false; // the image's memory is written, and no copy of it
    gpu::RowLayout layout = {};
    std::optional<ContentHash> key = {}; // of what is kept
};

/// For a copy to an image: no byte between rows.
gpu::RowLayout closeLayout(const gpu::ImageShape& shape, std::size_t texelBytes)
{
    gpu::RowLayout layout;
    for (std::uint32_t level = 0; level < shape.mips; ++level) {
        layout.levels.push_back({layout.bytes, std::max<std::size_t>(1, shape.width >> level) * texelBytes});
        layout.bytes += layout.levels.back().rowPitch * std::max<std::size_t>(1, shape.height >> level);
    }
    return layout;
}

std::vector<std::size_t> numbersOf(const gpu::RowLayout& layout)
{
    std::vector<std::size_t> numbers = {layout.bytes};
    for (const gpu::RowLayout::Level& level : layout.levels)
        numbers.insert(numbers.end(), {level.offset, level.rowPitch});
    return numbers;
}

TextureTask taskFor(const gpu::Device& device, const Scene& scene, const PlannedTexture& texture, int finestLevel,
                    const KeptLevels& kept)
{
    TextureTask task{.texture = texture, .pictures = partsOf(scene, texture)};
    const TextureImage& picture = anyOf(task.pictures);
    task.rule = {
        .content = texture.content, .weighByAlpha = texture.weighByAlpha, .lengthInAlpha = texture.lengthInAlpha};
    const TexelStorage storage = texture.words ? TexelStorage::words : storageOf(task.pictures[0].format(), task.rule);
    task.texelBytes = bytesPerTexel(storage);
    task.missing = static_cast<std::size_t>(finestLevel);
    const int levelCount = texture.sampler.mip != MipFilter::none ? mipCount(picture.width, picture.height) : 1;
    task.shape = {.width = static_cast<std::uint32_t>(std::max(1, picture.width >> finestLevel)),
                  .height = static_cast<std::uint32_t>(std::max(1, picture.height >> finestLevel)),
                  .mips = static_cast<std::uint32_t>(levelCount - finestLevel),
                  .format = formatOf(storage)};
    task.inPlace = gpu::canSampleRows(device, task.shape);
    task.layout = task.inPlace ? gpu::rowLayout(device, task.shape) : closeLayout(task.shape, task.texelBytes);
    if (kept.textures)
        task.key = levelsKey(texture, kept.encoded, finestLevel, numbersOf(task.layout));
    return task;
}

/// What lies between rows, and would be kept with them: whatever was in that memory before.
void clearGaps(const TextureTask& task, std::byte* memory)
{
    std::size_t written = 0;
    for (std::uint32_t i = 0; i < task.shape.mips; ++i) {
        const gpu::RowLayout::Level& level = task.layout.levels[i];
        const std::size_t row = std::max<std::size_t>(1, task.shape.width >> i) * task.texelBytes;
        for (std::size_t y = 0; y < std::max<std::size_t>(1, task.shape.height >> i); ++y) {
            const std::size_t begin = level.offset + y * level.rowPitch;
            std::fill(memory + written, memory + begin, std::byte(0));
            written = begin + row;
        }
    }
    std::fill(memory + written, memory + task.layout.bytes, std::byte(0));
}

/// Fills the memory of all levels; true where they were made and not read from what is kept.
bool fillLevels(const TextureTask& task, const KeptLevels& kept, std::byte* memory)
{
    if (task.key && kept.textures->readLevels(*task.key, {memory, task.layout.bytes}))
        return false;
    if (!hasTexels(task.pictures))
        throw TexelsMissing();
    std::vector<LevelMemory> levels(task.missing);
    for (const gpu::RowLayout::Level& level : task.layout.levels)
        levels.push_back({memory + level.offset, level.rowPitch});
    if (task.key)
        clearGaps(task, memory);
    if (task.texture.words)
        writeWordLevels(task.pictures, levels);
    else if (isOnePicture(task.pictures[0]))
        writeLevels(task.pictures[0].any(), task.rule, levels);
    else
        writePackedLevels(task.pictures[0], task.rule, levels);
    return true;
}

/// What is to be kept of a texture that was made, read where its image has it.
struct KeepTask
{
    ContentHash key;
    std::span<const std::byte> memory;
};

struct MadeTexture
{
    gpu::DeviceImage image;
    std::optional<KeepTask> keep = {};
};

MadeTexture makeInPlace(const gpu::Device& device, const TextureTask& task, const KeptLevels& kept)
{
    MadeTexture made = {.image = gpu::makeImage(device, task.shape, vk::ImageUsageFlagBits::eSampled,
                                                anyOf(task.pictures).name, gpu::ImageTiling::rows)};
    gpu::writeRows(made.image, [&](std::byte* memory) {
        if (fillLevels(task, kept, memory) && task.key)
            made.keep = KeepTask{*task.key, {memory, task.layout.bytes}};
    });
    return made;
}

MadeTexture makeByCopy(const gpu::Device& device, const TextureTask& task, const KeptLevels& kept)
{
    using Usage = vk::ImageUsageFlagBits;
    MadeTexture made = {
        .image = gpu::makeImage(device, task.shape, Usage::eSampled | Usage::eTransferDst, anyOf(task.pictures).name)};
    const gpu::Buffer staging = gpu::makeStagingBuffer(device, task.layout.bytes, "texels");
    if (fillLevels(task, kept, staging.mapped) && task.key) // what is copied from goes with the copy
        kept.textures->keepLevels(*task.key, {staging.mapped, task.layout.bytes});
    gpu::Commands commands(device);
    gpu::copyToImage(commands, staging, made.image, task.texelBytes);
    commands.submitAndWait();
    return made;
}

MadeTexture makeTexture(const gpu::Device& device, const TextureTask& task, const KeptLevels& kept,
                        std::optional<MappedFile> pages)
{
    if (pages)
        if (auto image =
                gpu::makeImageOver(device, task.shape, task.layout, std::move(*pages), anyOf(task.pictures).name))
            return {.image = std::move(*image)};
    return task.inPlace ? makeInPlace(device, task, kept) : makeByCopy(device, task, kept);
}

/// By task: what is kept of it and can be its image's memory as it is.
std::vector<std::optional<MappedFile>> keptPages(const gpu::Device& device, std::span<const TextureTask> tasks,
                                                 const KeptLevels& kept)
{
    std::vector<std::optional<MappedFile>> pages(tasks.size());
    if (kept.textures && device.importsHostPages())
        parallelFor(tasks.size(), 1, [&](std::size_t i) {
            if (tasks[i].key && tasks[i].inPlace)
                pages[i] = kept.textures->mapLevels(*tasks[i].key);
        });
    return pages;
}

// By Scene::images: one more than the number of the last texture that reads it; 0 where none does.
std::vector<std::size_t> lastReaders(const Scene& scene, const ShadingPlan& plan)
{
    std::vector<std::size_t> readers(scene.images.size(), 0);
    for (std::size_t i = 0; i < plan.textures.size(); ++i)
        for (const ChannelSource& source : sourcesOf(plan.textures[i]))
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
    std::vector<TextureTask> tasks;
    for (std::size_t i = 0; i < plan.textures.size(); ++i)
        tasks.push_back(taskFor(device, scene, plan.textures[i], finestLevels[i], kept));
    std::vector<std::optional<MappedFile>> pages = keptPages(device, tasks, kept);
    std::vector<KeepTask> toKeep;
    const auto lodBias = static_cast<float>(levelBias(plan.settings));
    for (std::size_t i = 0; i < plan.textures.size(); ++i) {
        const PlannedTexture& texture = plan.textures[i];
        MadeTexture made = makeTexture(device, tasks[i], kept, std::move(pages[i]));
        images.push_back(std::move(made.image));
        if (made.keep)
            toKeep.push_back(*made.keep);
        gpu::leaveOutUnread(device, images.back(), channelsRead(texture), "texture");
        if (!samplers.contains(texture.sampler))
            samplers.emplace(texture.sampler, makeSampler(device, texture.sampler, lodBias));
        samplerOf.push_back(texture.sampler);
        tellRead(i + 1);
    }
    gpu::Commands commands(device);
    commands.use(uses());
    commands.submitAndWait();
    if (!toKeep.empty()) // while the picture is drawn: nobody waits for a disk
        keeping = std::async(std::launch::async, [store = kept.textures, toKeep = std::move(toKeep)] {
            for (const KeepTask& task : toKeep)
                store->keepLevels(task.key, task.memory);
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
