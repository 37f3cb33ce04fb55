#include "passes/environment_upload.h"

#include "brdf/environment.h"
#include "brdf/irradiance_window.h"
#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "passes/dfg_upload.h"
#include "passes/light_cubes.h"
#include "prepare/irradiance.h"
#include "prepare/panorama.h"
#include "prepare/radiance_pyramid.h"

#include <algorithm>

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

std::array<vec3, 9> windowed(const std::array<vec3, 9>& harmonics)
{
    std::array<dvec3, 9> exact;
    std::ranges::copy(harmonics, exact.begin());
    exact = brdf::windowedHarmonics(exact);
    std::array<vec3, 9> result;
    std::ranges::copy(exact, result.begin());
    return result;
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

const EnvironmentStore::LightCubes& EnvironmentStore::lightCubes(const Image& radiance, const ContentHash& content,
                                                                 const brdf::Method& specular)
{
    const std::string key = content.hex() + std::string(specular.ownModel);
    if (const auto found = cubes.find(key); found != cubes.end())
        return found->second;
    const EnvironmentMaps maps = cachedEnvironmentMaps(specular, radiance, content, cache);
    return cubes
        .emplace(key, LightCubes{uploadCube(device, maps.specular, "prefiltered environment"),
                                 uploadCube(device, maps.irradiance, "irradiance")})
        .first->second;
}

const gpu::DeviceImage& EnvironmentStore::radianceCube(const Image& radiance, const ContentHash& content)
{
    const std::string key = content.hex();
    if (const auto found = radianceCubes.find(key); found != radianceCubes.end())
        return found->second;
    const brdf::Method& splitSum = *brdf::findMethod(brdf::Slot::environmentSpecular, "split_sum");
    const EnvironmentMaps maps = cachedEnvironmentMaps(splitSum, radiance, content, cache);
    const CubeLevels pyramid = radiancePyramid(maps.specular.data.front(), maps.specular.size);
    return radianceCubes.emplace(key, uploadCube(device, pyramid, "radiance")).first->second;
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

const gpu::DeviceImage* EnvironmentStore::albedoTable(const brdf::Preset& methods)
{
    const brdf::DfgStorage* storage = methods.dfg ? brdf::findDfgTable(methods.dfg->id) : nullptr;
    if (methods.dfg && !storage)
        return nullptr;
    const std::string_view key = storage ? storage->id : "integration map";
    if (const auto found = albedoTables.find(key); found != albedoTables.end())
        return &found->second;
    gpu::DeviceImage table = storage ? uploadDfgTable(device, *storage) : uploadIntegrationMap(device);
    return &albedoTables.emplace(key, std::move(table)).first->second;
}

void EnvironmentStore::addLight(EnvironmentImages& images, const Image& radiance, const ContentHash& content,
                                const brdf::Preset& methods)
{
    const brdf::Method& specular = *methods.environmentSpecular;
    if (specular.id == "mirror") { // nothing is prefiltered
        images.panorama = &panorama(radiance, content);
        return;
    }
    const LightCubes& light = lightCubes(radiance, content, specular);
    const std::string_view diffuse = methods.environmentDiffuse->id;
    const bool samples = brdf::drawsSamples(specular);
    if (diffuse == "irradiance_cube")
        images.diffuse = &light.diffuse;
    else if (diffuse != "sampled")
        images.harmonics =
            diffuse == "sh9_windowed" ? windowed(irradianceHarmonics(radiance)) : irradianceHarmonics(radiance);
    if (!samples)
        images.specular = &light.specular;
    if (samples || diffuse == "sampled")
        images.radiance = &radianceCube(radiance, content);
}

EnvironmentImages EnvironmentStore::get(const Scene& scene, const ShadingPlan& plan)
{
    EnvironmentImages images;
    if (plan.environmentLight || plan.panorama) {
        const Image& radiance = scene.environment->radiance;
        const ContentHash content = contentOf(radiance);
        if (plan.environmentLight)
            addLight(images, radiance, content, plan.settings.methods);
        if (plan.panorama)
            images.panorama = &panorama(radiance, content);
    }
    if (plan.dfgTable)
        images.dfg = albedoTable(plan.settings.methods);
    return images;
}

} // namespace torrance
