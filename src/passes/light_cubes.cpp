#include "passes/light_cubes.h"

#include "core/data_folder.h"
#include "gpu/unread_channels.h"
#include "passes/image_fill.h"

#include <cstring>

namespace torrance {
namespace {

constexpr vk::Format kFloatFormat =
    vk::Format::eR32G32B32A32Sfloat; // suns of 1e5 and more have no place in half floats
constexpr std::size_t kTexelBytes = 16;
constexpr const char* kSpecularName = "prefiltered environment";
constexpr const char* kDiffuseName = "irradiance";

gpu::DeviceImage makeCube(const gpu::Device& device, std::uint32_t size, std::uint32_t levels, CubeAlpha alpha,
                          const char* name)
{
    using Usage = vk::ImageUsageFlagBits;
    gpu::DeviceImage image = gpu::makeImage(
        device, {.width = size, .height = size, .mips = levels, .layers = 6, .cube = true, .format = kFloatFormat},
        Usage::eSampled | Usage::eTransferDst, name);
    gpu::leaveOutUnread(device, image, {true, true, true, alpha == CubeAlpha::read}, name);
    return image;
}

/// Nothing where the file turns out to be damaged: what was uploaded is not looked at.
std::optional<LightCubes> upload(const gpu::Device& device, KeptResult kept)
{
    const auto shape = readShape(kept);
    if (!shape)
        return std::nullopt;
    LightCubes cubes = {makeCube(device, shape->size, shape->levels, CubeAlpha::unread, kSpecularName),
                        makeCube(device, shape->irradianceSize, 1, CubeAlpha::unread, kDiffuseName)};
    const auto next = [&](std::span<std::byte> to) { return kept.read(to); };
    const bool whole = fillImage(device, cubes.specular, kTexelBytes, next) &&
                       fillImage(device, cubes.diffuse, kTexelBytes, next) && kept.isIntact();
    return whole ? std::optional(std::move(cubes)) : std::nullopt;
}

/// What `use` makes of the first file that keeps the maps undamaged.
template <typename Use>
auto fromKept(const ContentHash& key, const DiskCache& cache, const Use& use) -> decltype(use(*cache.open(key)))
{
    if (auto shipped = openResult(dataFolder() / "prefiltered" / key.hex(), key))
        if (auto result = use(std::move(*shipped)))
            return result;
    if (auto cached = cache.open(key))
        return use(std::move(*cached));
    return std::nullopt;
}

EnvironmentMaps makeAndKeep(const brdf::Method& specular, const Image& radiance, const ContentHash& key,
                            DiskCache& cache)
{
    EnvironmentMaps maps = makeMaps(specular, radiance);
    cache.store(key, KeptForm(maps).parts());
    return maps;
}

} // namespace

gpu::DeviceImage uploadCube(const gpu::Device& device, const CubeLevels& cube, CubeAlpha alpha, const char* name)
{
    gpu::DeviceImage image =
        makeCube(device, static_cast<std::uint32_t>(cube.size), static_cast<std::uint32_t>(cube.levels), alpha, name);
    std::size_t level = 0, done = 0; // bytes of it
    fillImage(device, image, kTexelBytes, [&](std::span<std::byte> to) {
        while (!to.empty()) {
            const auto left = std::as_bytes(std::span(cube.data[level])).subspan(done);
            const std::size_t count = std::min(left.size(), to.size());
            std::memcpy(to.data(), left.data(), count);
            to = to.subspan(count);
            done = count == left.size() ? 0 : done + count;
            level += done == 0;
        }
        return true;
    });
    return image;
}

LightCubes makeLightCubes(const gpu::Device& device, const brdf::Method& specular, const Image& radiance,
                          const ContentHash& content, DiskCache& cache)
{
    const ContentHash key = mapsKey(specular, content);
    if (auto kept = fromKept(key, cache, [&](KeptResult file) { return upload(device, std::move(file)); }))
        return std::move(*kept);
    const EnvironmentMaps maps = makeAndKeep(specular, radiance, key, cache);
    return {uploadCube(device, maps.specular, CubeAlpha::unread, kSpecularName),
            uploadCube(device, maps.irradiance, CubeAlpha::unread, kDiffuseName)};
}

EnvironmentMaps keptEnvironmentMaps(const brdf::Method& specular, const Image& radiance, const ContentHash& content,
                                    DiskCache& cache)
{
    const ContentHash key = mapsKey(specular, content);
    if (auto kept = fromKept(key, cache, [](KeptResult file) { return readMaps(std::move(file)); }))
        return std::move(*kept);
    return makeAndKeep(specular, radiance, key, cache);
}

} // namespace torrance
