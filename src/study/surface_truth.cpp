#include "study/surface_truth.h"

#include "core/parallel.h"
#include "math/replicates.h"
#include "math/scrambled_sequence.h"
#include "reference/light_integral.h"
#include "reference/reference_settings.h"
#include "reference/shade.h"
#include "scene/camera_view.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <string_view>

namespace torrance {
namespace {

const Image& layer(const Picture& picture, std::string_view name)
{
    const auto found = std::ranges::find(picture.layers, name, &Layer::name);
    assert(found != picture.layers.end());
    return found->image;
}

dvec3 colorAt(const Image& image, int x, int y)
{
    const float* c = image.at(x, y);
    return {c[0], c[1], c[2]};
}

struct Surfaces
{
    explicit Surfaces(const Picture& picture)
        : position(layer(picture, "position")), normal(layer(picture, "normal")),
          baseColor(layer(picture, "base_color")), metallic(layer(picture, "metallic")),
          roughness(layer(picture, "roughness")), occlusion(layer(picture, "occlusion")),
          emissive(layer(picture, "emissive")), material(layer(picture, "material_id"))
    {
    }

    MaterialPoint at(int x, int y, const Material& of) const
    {
        MaterialPoint point;
        point.baseColor = colorAt(baseColor, x, y);
        point.metallic = metallic.at(x, y)[0];
        point.perceptualRoughness = roughness.at(x, y)[0];
        point.ior = of.ior;
        point.occlusion = occlusion.at(x, y)[0];
        point.emissive = colorAt(emissive, x, y);
        point.normal = glm::normalize(colorAt(normal, x, y));
        point.unlit = of.unlit;
        return point;
    }

    const Image &position, &normal, &baseColor, &metallic, &roughness, &occlusion, &emissive, &material;
};

bool isSphere(const Light& light)
{
    return light.radius > 0.0 && light.kind != Light::Kind::directional;
}

} // namespace

SurfaceTruth surfaceTruth(const Scene& scene, const Camera& camera, const brdf::Preset& methods, const Picture& picture,
                          int directions, const std::function<bool()>& stop)
{
    const Surfaces surfaces(picture);
    const int width = picture.color.width, height = picture.color.height;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    SurfaceTruth truth = {std::vector<Replicates>(pixels), std::vector<bool>(pixels, false)};
    std::vector<std::uint8_t> counted(pixels, 0);
    std::vector<Light> exactLights, balls;
    for (const Light& light : scene.lights)
        (isSphere(light) ? balls : exactLights).push_back(light);
    std::optional<EnvironmentSampler> sampler;
    if (scene.environment)
        sampler.emplace(*scene.environment);
    const bool lit = sampler && !sampler->dark();
    const dvec3 eye = cameraPosition(camera);
    const Yardstick yardstick = &methods;
    const auto turns = static_cast<std::uint32_t>(directions / kDirectionsPerRound);
    const Material defaultMaterial;
    parallelFor(static_cast<std::size_t>(height), 1, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < width && !stop(); ++x) {
            const auto id = static_cast<std::size_t>(surfaces.material.at(x, y)[0]); // material + 1
            if (id == 0)
                continue;
            const Material& material = id <= scene.materials.size() ? scene.materials[id - 1] : defaultMaterial;
            if (material.alphaMode == AlphaMode::blend)
                continue;
            const std::size_t place = row * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
            counted[place] = 1;
            const MaterialPoint point = surfaces.at(x, y, material);
            const dvec3 position = colorAt(surfaces.position, x, y) - eye;
            const Ray ray = primaryRay(camera, width, height, x + 0.5, y + 0.5);
            const dvec3 view = -glm::normalize(ray.direction);
            const dvec3 color = shade(methods, {exactLights}, point, eye, position, view);
            std::vector<LightIntegral> integrals;
            if (!point.unlit) {
                if (lit && point.occlusion != 0.0)
                    integrals.emplace_back(yardstick, &*sampler, point, view, DirectionChoice::combined);
                for (const Light& ball : balls)
                    integrals.emplace_back(yardstick, SphereLight(ball, eye, position), point, view,
                                           DirectionChoice::combined);
            }
            Replicates& light = truth.light[place];
            for (std::uint64_t replicate = 0; replicate < kReplicates; ++replicate) {
                light.values[replicate] = color;
                for (std::uint64_t i = 0; i < integrals.size(); ++i)
                    light.values[replicate] += integrals[i].sumOfTurns(hashNumbers({place, i, replicate}), 0, turns) /
                                               (double(turns) * kDirectionsPerTurn);
            }
        }
    });
    for (std::size_t i = 0; i < counted.size(); ++i)
        truth.counted[i] = counted[i] != 0;
    return truth;
}

} // namespace torrance
