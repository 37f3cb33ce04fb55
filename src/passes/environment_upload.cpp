#include "passes/environment_upload.h"

#include "brdf/environment.h"
#include "brdf/irradiance_window.h"
#include "passes/dfg_upload.h"
#include "passes/image_fill.h"
#include "prepare/irradiance.h"
#include "prepare/panorama.h"
#include "prepare/radiance_cube.h"
#include "prepare/radiance_pyramid.h"

#include <algorithm>
#include <optional>

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

// Whose chain holds the radiance itself and its means over GGX lobes.
const brdf::Method& splitSum()
{
    return *brdf::findMethod(brdf::Slot::environmentSpecular, "split_sum");
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

const gpu::DeviceImage& EnvironmentStore::radianceCube(const Image& radiance, const ContentHash& content, int size)
{
    const std::string key = content.hex() + " " + std::to_string(size);
    if (const auto found = radianceCubes.find(key); found != radianceCubes.end())
        return found->second;
    const std::vector<float> texels = cubeTexels(radiance, content, size);
    return radianceCubes.emplace(key, uploadCube(device, radiancePyramid(texels, size), CubeAlpha::unread, "radiance"))
        .first->second;
}

// The radiance itself: level 0 of the chain where that has this size.
std::vector<float> EnvironmentStore::cubeTexels(const Image& radiance, const ContentHash& content, int size)
{
    if (size != cubeSizeFor(radiance.width))
        return std::move(makeRadianceCube(radiance, size).radiance);
    return std::move(keptEnvironmentMaps(splitSum(), radiance, content, cache).specular.data.front());
}

const LampImages& EnvironmentStore::lamps(const Image& radiance, const ContentHash& content, int size, int points)
{
    const std::string key = content.hex() + " " + std::to_string(size) + " " + std::to_string(points);
    if (const auto found = lampImages.find(key); found != lampImages.end())
        return found->second;
    EnvironmentLamps split = splitLamps(cubeTexels(radiance, content, size), size, points);
    return lampImages
        .emplace(key, LampImages{uploadCube(device, split.rest, CubeAlpha::unread, "radiance without lamps"),
                                 uploadCube(device, split.lamps, CubeAlpha::read, "lamps"), std::move(split.points),
                                 split.densities})
        .first->second;
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
                                const Settings& settings)
{
    const brdf::Preset& methods = settings.methods;
    const brdf::Method& specular = *methods.environmentSpecular;
    if (specular.id == "mirror") { // nothing is prefiltered
        images.panorama = &panorama(radiance, content);
        return;
    }
    const std::string_view diffuse = methods.environmentDiffuse->id;
    const bool samples = brdf::drawsSamples(specular);
    const auto light = [&]() -> const LightCubes& { return lightCubes(radiance, content, specular); };
    if (specular.id == "even")
        images.harmonics = irradianceHarmonics(radiance);
    if (diffuse == "irradiance_cube")
        images.diffuse = &light().diffuse;
    else if (diffuse != "sampled")
        images.harmonics =
            diffuse == "sh9_windowed" ? windowed(irradianceHarmonics(radiance)) : irradianceHarmonics(radiance);
    if (specular.id != "even" && !samples)
        images.specular = &light().specular;
    const int size = drawnCubeSize(radiance.width, settings.environmentSamples);
    if (brdf::hasLampPoints(specular)) { // the plan keeps it from a method that reads the whole radiance
        const LampImages& split = lamps(radiance, content, size, brdf::lampPointCount(settings.environmentSamples));
        images.radiance = &split.rest;
        images.lamps = &split.lamps;
        images.lampPoints = split.points;
        images.lampDensities = split.densities;
    } else if (samples || diffuse == "sampled") {
        images.radiance = &radianceCube(radiance, content, size);
    }
}

std::vector<EnvironmentImages> EnvironmentStore::get(const Scene& scene, const ShadingPlan& plan)
{
    const std::lock_guard lock(mutex);
    EnvironmentImages all; // what all choices read
    std::optional<ContentHash> known;
    if (plan.environmentLight || plan.panorama) {
        const Image& radiance = scene.environment->radiance;
        known = panoramaContent(radiance);
        if (plan.panorama && plan.settings.backgroundBlur > 0.0)
            all.background = &lightCubes(radiance, *known, splitSum()).specular;
        else if (plan.panorama)
            all.panorama = &panorama(radiance, *known);
    }
    std::vector<EnvironmentImages> images(plan.choices.size(), all);
    for (std::size_t i = 0; i < images.size(); ++i) {
        if (plan.environmentLight)
            addLight(images[i], scene.environment->radiance, *known, plan.choices[i]);
        if (plan.dfgTable)
            images[i].dfg = albedoTable(plan.choices[i].methods);
    }
    return images;
}

} // namespace torrance
