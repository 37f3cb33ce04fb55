#include "passes/environment_upload.h"

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "passes/dfg_upload.h"
#include "passes/light_cubes.h"
#include "prepare/irradiance.h"
#include "prepare/panorama.h"

namespace torrance {
namespace {

constexpr vk::Format kFloatFormat =
    vk::Format::eR32G32B32A32Sfloat; // suns of 1e5 and more have no place in half floats
constexpr std::size_t kTexelBytes = 16;

gpu::DeviceImage upload(const gpu::Device& device, gpu::ImageShape shape, std::span<const std::byte> texels,
                        const char* name)
{
    using Usage = vk::ImageUsageFlagBits;
    shape.format = kFloatFormat;
    gpu::DeviceImage image = gpu::makeImage(device, shape, Usage::eSampled | Usage::eTransferDst, name);
    const gpu::Buffer staging = gpu::makeBuffer(device, texels, vk::BufferUsageFlagBits::eTransferSrc, name);
    gpu::Commands commands(device);
    gpu::copyToImage(commands, staging, image, kTexelBytes);
    commands.submitAndWait();
    return image;
}

gpu::DeviceImage uploadCube(const gpu::Device& device, const CubeLevels& cube, const char* name)
{
    std::vector<float> texels;
    for (const std::vector<float>& level : cube.data)
        texels.insert(texels.end(), level.begin(), level.end());
    const auto size = static_cast<std::uint32_t>(cube.size);
    return upload(
        device,
        {.width = size, .height = size, .mips = static_cast<std::uint32_t>(cube.levels), .layers = 6, .cube = true},
        std::as_bytes(std::span(texels)), name);
}

constexpr std::uintmax_t kMaxCacheBytes = 512u << 20; // some dozen environments

ContentHash contentOf(const Image& radiance)
{
    return ContentHasher()
        .add(radiance.width)
        .add(radiance.height)
        .add(std::as_bytes(std::span(radiance.texels)))
        .finish();
}

} // namespace

EnvironmentStore::EnvironmentStore(const gpu::Device& d, const std::filesystem::path& folder)
    : device(d), cache(folder.empty() ? folder : folder / "environments", kMaxCacheBytes)
{
}

const EnvironmentStore::LightCubes& EnvironmentStore::lightCubes(const Image& radiance, const ContentHash& content)
{
    const std::string key = content.hex();
    if (const auto found = cubes.find(key); found != cubes.end())
        return found->second;
    const EnvironmentMaps maps = cachedEnvironmentMaps(radiance, content, cache);
    return cubes
        .emplace(key, LightCubes{uploadCube(device, maps.specular, "prefiltered environment"),
                                 uploadCube(device, maps.irradiance, "irradiance")})
        .first->second;
}

const gpu::DeviceImage& EnvironmentStore::panorama(const Image& radiance, const ContentHash& content)
{
    const std::string key = content.hex();
    if (const auto found = panoramas.find(key); found != panoramas.end())
        return found->second;
    const std::vector<Image> levels = panoramaLevels(radiance);
    std::vector<float> texels;
    for (const Image& level : levels)
        texels.insert(texels.end(), level.texels.begin(), level.texels.end());
    const gpu::ImageShape shape = {.width = static_cast<std::uint32_t>(radiance.width),
                                   .height = static_cast<std::uint32_t>(radiance.height),
                                   .mips = static_cast<std::uint32_t>(levels.size())};
    return panoramas.emplace(key, upload(device, shape, std::as_bytes(std::span(texels)), "panorama")).first->second;
}

const gpu::DeviceImage& EnvironmentStore::dfgTable(const brdf::DfgStorage& storage)
{
    const auto found = dfgTables.find(storage.id);
    return found != dfgTables.end() ? found->second
                                    : dfgTables.emplace(storage.id, uploadDfgTable(device, storage)).first->second;
}

EnvironmentImages EnvironmentStore::get(const Scene& scene, const ShadingPlan& plan)
{
    EnvironmentImages images;
    if (plan.environmentLight || plan.panorama) {
        const Image& radiance = scene.environment->radiance;
        const ContentHash content = contentOf(radiance);
        if (plan.environmentLight) {
            const LightCubes& light = lightCubes(radiance, content);
            images.specular = &light.specular;
            if (plan.settings.methods.environmentDiffuse->id == "sh9")
                images.harmonics = irradianceHarmonics(radiance);
            else
                images.diffuse = &light.diffuse;
        }
        if (plan.panorama)
            images.panorama = &panorama(radiance, content);
    }
    if (plan.dfgTable)
        if (const brdf::DfgStorage* table = brdf::findDfgTable(plan.settings.methods.dfg->id)) // a fit has none
            images.dfg = &dfgTable(*table);
    return images;
}

} // namespace torrance
