#include "passes/environment_upload.h"

#include "brdf/environment.h"
#include "brdf/irradiance_window.h"
#include "passes/dfg_upload.h"
#include "passes/image_fill.h"
#include "prepare/irradiance.h"
#include "prepare/panorama.h"
#include "prepare/radiance_pyramid.h"

#include <algorithm>

namespace torrance {
namespace {

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

} // namespace

EnvironmentStore::EnvironmentStore(const gpu::Device& d, const std::filesystem::path& folder)
    : device(d), cache(folder.empty() ? folder : folder / "environments", kMaxCacheBytes)
{
}

const LightCubes& EnvironmentStore::lightCubes(const Image& radiance, const ContentHash& content,
                                               const brdf::Method& specular)
{
    const std::string key = content.hex() + std::string(specular.ownModel);
    if (const auto found = cubes.find(key); found != cubes.end())
        return found->second;
    return cubes.emplace(key, makeLightCubes(device, specular, radiance, content, cache)).first->second;
}

const gpu::DeviceImage& EnvironmentStore::radianceCube(const Image& radiance, const ContentHash& content)
{
    const std::string key = content.hex();
    if (const auto found = radianceCubes.find(key); found != radianceCubes.end())
        return found->second;
    const brdf::Method& splitSum = *brdf::findMethod(brdf::Slot::environmentSpecular, "split_sum");
    const EnvironmentMaps maps = keptEnvironmentMaps(splitSum, radiance, content, cache);
    const CubeLevels pyramid = radiancePyramid(maps.specular.data.front(), maps.specular.size);
    return radianceCubes.emplace(key, uploadCube(device, pyramid, "radiance")).first->second;
}

const gpu::DeviceImage& EnvironmentStore::panorama(const Image& radiance, const ContentHash& content)
{
    const std::string key = content.hex();
    if (const auto found = panoramas.find(key); found != panoramas.end())
        return found->second;
    using Usage = vk::ImageUsageFlagBits;
    PanoramaTexels texels(radiance);
    gpu::DeviceImage image = gpu::makeImage(device,
                                            {.width = static_cast<std::uint32_t>(radiance.width),
                                             .height = static_cast<std::uint32_t>(radiance.height),
                                             .mips = static_cast<std::uint32_t>(texels.levels()),
                                             .format = vk::Format::eR32G32B32A32Sfloat},
                                            Usage::eSampled | Usage::eTransferDst, "panorama");
    fillImage(device, image, 4 * sizeof(float), [&](std::span<std::byte> to) {
        texels.next({reinterpret_cast<float*>(to.data()), to.size() / sizeof(float)});
        return true;
    });
    return panoramas.emplace(key, std::move(image)).first->second;
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
        const ContentHash content = panoramaContent(radiance);
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
