#include "study/sphere_truth.h"

#include "brdf/random_walk.h"
#include "core/parallel.h"
#include "math/frame.h"
#include "math/replicates.h"
#include "math/scrambled_sequence.h"
#include "reference/physical_surface.h"
#include "reference/reference_picture.h"
#include "reference/shade.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

const dvec3 kView(0.0, 0.0, 1.0); // of an orthographic camera

struct Estimated
{
    dvec3 color, variance;
};

// Sphere by sphere and ring by ring would be kinder to caches of albedos; rows do.
SphereTruth computed(const MethodGrid& grid, const Checkpoint& checkpoint,
                     const std::function<Estimated(const SpherePixel&, std::uint64_t)>& pixel)
{
    const Settings size = sphereSettings(grid, {});
    SphereTruth truth = {Image(size.width, size.height, 3), Image(size.width, size.height, 3)};
    parallelFor(static_cast<std::size_t>(size.height), 1, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        if (checkpoint)
            checkpoint();
        for (int x = 0; x < size.width; ++x)
            if (const auto seen = spherePixel(grid, x, y)) {
                const Estimated e = pixel(*seen, row * static_cast<std::size_t>(size.width) + std::size_t(x));
                for (int c = 0; c < 3; ++c) {
                    truth.color.at(x, y)[c] = static_cast<float>(e.color[c]);
                    truth.variance.at(x, y)[c] = static_cast<float>(e.variance[c]);
                }
            }
    });
    return truth;
}

SphereTruth exact(SphereTruth truth)
{
    truth.variance = {};
    return truth;
}

// Of a conductor of index 1 + i k with this normal reflectance.
dvec3 extinctionOf(const dvec3& reflectance)
{
    const dvec3 r = glm::min(reflectance, dvec3(kMostReflectance));
    return 2.0 * glm::sqrt(r / (1.0 - r));
}

dvec3 colorOf(const Material& material)
{
    return dvec3(material.baseColorFactor);
}

dvec3 irradianceOf(const Light& light)
{
    return light.color * light.intensity;
}

dvec3 lampLight(const brdf::Preset& methods, const Material& material, const dvec3& normal,
                std::span<const Light> lights)
{
    dvec3 sum(0.0);
    for (const Light& light : lights) {
        brdf::ShadingPoint point = brdf::makeShadingPoint(normal, kView, -light.direction, material.roughnessFactor);
        point.baseColor = colorOf(material);
        point.metallic = material.metallicFactor;
        point.ior = material.ior;
        point.eta = dvec3(1.0);
        point.k = extinctionOf(point.baseColor);
        sum += std::get<brdf::ModelFormula>(methods.model->formula)(methods, point).response() * irradianceOf(light);
    }
    return sum;
}

// What walks add, one estimate a walk and lamp.
dvec3 walkLight(const Material& material, const dvec3& normal, std::span<const Light> lights, NumberStream& numbers)
{
    const double alpha = std::max(material.roughnessFactor * material.roughnessFactor, brdf::kMinAlpha);
    const brdf::FacetInterface facets = {.k = extinctionOf(colorOf(material)), .ior = material.ior};
    const dmat3 worldFromLocal = frameAround(normal);
    const dvec3 v = kView * worldFromLocal;
    dvec3 sum(0.0);
    for (const Light& light : lights) {
        const dvec3 l = -light.direction * worldFromLocal;
        if (!(l.z > 0.0))
            continue;
        const dvec4 response = brdf::walkResponse(v, l, alpha, facets, 2, numbers);
        sum += glm::mix(dvec3(response.a), dvec3(response), material.metallicFactor) * irradianceOf(light);
    }
    return sum;
}

} // namespace

SphereTruth lampTruth(const MethodGrid& grid, const Scene& scene, const MethodsOf& methods,
                      const Checkpoint& checkpoint)
{
    return exact(computed(grid, checkpoint, [&](const SpherePixel& pixel, std::uint64_t) {
        const std::size_t material = sphereMaterial(grid, pixel);
        return Estimated{lampLight(methods(material), scene.materials[material], pixel.normal, scene.lights),
                         dvec3(0.0)};
    }));
}

SphereTruth walkTruth(const MethodGrid& grid, const Scene& scene, const brdf::Preset& once,
                      const Checkpoint& checkpoint)
{
    constexpr int kWalks = 64; // of each replicate
    return computed(grid, checkpoint, [&](const SpherePixel& pixel, std::uint64_t place) {
        const Material& material = scene.materials[sphereMaterial(grid, pixel)];
        Replicates sums;
        for (std::uint64_t i = 0; i < kReplicates; ++i) {
            NumberStream numbers(hashNumbers({place, i}));
            for (int walk = 0; walk < kWalks; ++walk)
                sums.values[i] += walkLight(material, pixel.normal, scene.lights, numbers) / double(kWalks);
        }
        return Estimated{lampLight(once, material, pixel.normal, scene.lights) + sums.mean(), sums.variance()};
    });
}

SphereTruth uniformTruth(const MethodGrid& grid, const Scene& scene, const MethodsOf& methods,
                         const Checkpoint& checkpoint)
{
    return exact(computed(grid, checkpoint, [&](const SpherePixel& pixel, std::uint64_t) {
        const std::size_t index = sphereMaterial(grid, pixel);
        const Material& material = scene.materials[index];
        MaterialPoint point;
        point.baseColor = colorOf(material);
        point.metallic = material.metallicFactor;
        point.perceptualRoughness = material.roughnessFactor;
        point.ior = material.ior;
        point.normal = pixel.normal;
        return Estimated{shadeFurnace(methods(index), point, kView, dvec3(1.0)), dvec3(0.0)};
    }));
}

SphereTruth integralTruth(const MethodGrid& grid, const Scene& scene, const brdf::Preset& methods,
                          SpheresWithLight which, const Checkpoint& checkpoint)
{
    constexpr int kDirections = 1024;
    const Settings size = sphereSettings(grid, methods);
    ReferenceSettings settings;
    settings.methods = methods;
    settings.width = size.width;
    settings.height = size.height;
    settings.directions = kDirections;
    settings.background = dvec4(0.0);
    const Camera camera = sphereCamera(grid);
    const PixelEstimator estimator(scene, camera, settings);
    return computed(grid, checkpoint, [&](const SpherePixel& pixel, std::uint64_t place) {
        if (which == SpheresWithLight::dielectrics && scene.materials[sphereMaterial(grid, pixel)].metallicFactor > 0.0)
            return Estimated{dvec3(0.0), dvec3(0.0)};
        const int width = settings.width, at = static_cast<int>(place);
        const PixelEstimate e = estimator.estimate(at % width, at / width, 0.0);
        return Estimated{dvec3(e.color), e.variance};
    });
}

SphereTruth difference(const SphereTruth& a, const SphereTruth& b)
{
    SphereTruth result = a;
    for (std::size_t i = 0; i < result.color.texels.size(); ++i)
        result.color.texels[i] -= b.color.texels[i];
    for (std::size_t i = 0; i < result.variance.texels.size(); ++i) {
        const float deviation = std::sqrt(a.variance.texels[i]) + std::sqrt(b.variance.texels[i]);
        result.variance.texels[i] = deviation * deviation;
    }
    return result;
}

} // namespace torrance
