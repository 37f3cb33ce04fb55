#include "reference/pixel_estimate.h"

#include "core/error.h"
#include "math/norm.h"
#include "reference/path_tracer.h"
#include "reference/shade.h"
#include "scene/camera_view.h"

#include <algorithm>

namespace torrance {
namespace {

/// Of the materials of a scene, for one table of albedos serves them all.
double commonIor(const Scene& scene)
{
    const double ior = scene.materials.empty() ? Material{}.ior : scene.materials.front().ior;
    for (const Material& material : scene.materials)
        if (material.ior != ior)
            throw usageError("the yardstick physics takes one index of refraction, and " + material.name +
                                 " has another than " + scene.materials.front().name,
                             "use --yardstick model");
    return ior;
}

} // namespace

/// What lights a surface point from more than one direction, with the point's share of the pixel.
struct PixelEstimator::Point
{
    std::variant<LightIntegral, PathIntegral> integral;
    double share;
    std::uint64_t key;

    dvec3 sumOfTurns(std::uint64_t numbers, std::uint32_t first, std::uint32_t turns) const
    {
        return share * std::visit([&](const auto& i) { return i.sumOfTurns(numbers, first, turns); }, integral);
    }
};

PixelEstimator::PixelEstimator(const Scene& scene, const Camera& c, const ReferenceSettings& s)
    : settings(s), yardstick(&s.methods), camera(c), caster(scene, cameraPosition(c)),
      offsets(sampleOffsets(s.pixelSamples)),
      holes(std::ranges::any_of(scene.materials, [](const Material& m) { return m.alphaMode != AlphaMode::opaque; }))
{
    if (settings.physics)
        yardstick = &interfaceAlbedo.emplace(commonIor(scene));
    for (const Light& light : scene.lights)
        (settings.physics || isSphere(light) ? estimatedLights : exactLights).push_back(light);
    if (scene.environment)
        environment.emplace(*scene.environment);
    if (environment && environment->dark())
        environment.reset();
    if (settings.transport)
        paths = std::make_unique<PathTracer>(caster, yardstick, surroundings(), settings.choice);
}

PixelEstimator::~PixelEstimator() = default;

dvec4 PixelEstimator::backgroundOf(const Ray& ray) const
{
    if (settings.background)
        return *settings.background;
    return environment ? dvec4(environment->at(ray.direction).radiance, 1.0) : dvec4(0.0, 0.0, 0.0, 1.0);
}

void PixelEstimator::addSurface(const VisibleSurface& seen, double share, std::uint64_t key, std::vector<Point>& points,
                                PixelEstimate& exact) const
{
    const auto& [surface, material, alpha] = seen;
    if (paths) {
        exact.color += share * dvec4(paths->exactLight(seen), 1.0);
        if (!material.unlit)
            points.push_back({PathIntegral{*paths, seen}, share, hashNumbers({key, 0})});
        return;
    }
    exact.color +=
        share *
        dvec4(shade(settings.methods, {exactLights}, material, caster.origin(), surface.position, surface.view), 1.0);
    if (material.unlit)
        return;
    const auto add = [&](LightIntegral::Source source, std::uint64_t light) {
        points.push_back({LightIntegral(yardstick, std::move(source), material, surface.view, settings.choice), share,
                          hashNumbers({key, light})});
    };
    if (environment && material.occlusion != 0.0)
        add(&*environment, 0);
    for (std::size_t i = 0; i < estimatedLights.size(); ++i) {
        const Light& light = estimatedLights[i];
        if (isSphere(light))
            add(SphereLight(light, caster.origin(), surface.position), i + 1);
        else
            add(sampleLight(light, caster.origin(), surface.position), i + 1);
    }
}

std::uint64_t PixelEstimator::numberOf(int x, int y) const
{
    return static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(settings.width) + static_cast<std::uint64_t>(x);
}

void PixelEstimator::gatherPlace(const dvec2& place, const ivec2& pixel, double weight, std::uint64_t key,
                                 std::vector<Point>& points, PixelEstimate& exact) const
{
    const VisibleSurfaces seen = surfacesAt(place, pixel);
    for (std::size_t i = 0; i < seen.surfaces.size(); ++i)
        addSurface(seen.surfaces[i], weight * seen.surfaces[i].share, hashNumbers({key, i}), points, exact);
    exact.covered += seen.surfaces.empty() ? 0.0 : weight;
    exact.color += weight * seen.through * backgroundOf(rayAt(place.x, place.y));
}

void PixelEstimator::gather(int x, int y, std::uint64_t seed, std::vector<Point>& points, PixelEstimate& exact) const
{
    const double weight = 1.0 / static_cast<double>(offsets.size());
    for (std::size_t sample = 0; sample < offsets.size(); ++sample)
        gatherPlace(dvec2(x + 0.5, y + 0.5) + offsets[sample], {x, y}, weight,
                    hashNumbers({seed, numberOf(x, y), sample}), points, exact);
}

Ray PixelEstimator::rayAt(double x, double y) const
{
    return primaryRay(camera, settings.width, settings.height, x, y);
}

std::optional<QuadRays> PixelEstimator::quadOf(const dvec2& place, const ivec2& pixel) const
{
    if (!settings.levelBias)
        return std::nullopt;
    const double x = place.x - pixel.x % 2, y = place.y - pixel.y % 2;
    return QuadRays{rayAt(x, y), rayAt(x + 1.0, y), rayAt(x, y + 1.0), *settings.levelBias};
}

VisibleSurfaces PixelEstimator::surfacesAt(const dvec2& place, const ivec2& pixel) const
{
    const std::optional<QuadRays> quad = quadOf(place, pixel);
    return visibleSurfaces(caster, rayAt(place.x, place.y), quad ? &*quad : nullptr);
}

std::optional<Hit> PixelEstimator::seenFrom(int x, int y) const
{
    // Only a hole depends on how textures are filtered.
    const dvec2 center(x + 0.5, y + 0.5);
    const std::optional<QuadRays> quad = holes ? quadOf(center, {x, y}) : std::nullopt;
    return firstVisible(caster, rayAt(center.x, center.y), quad ? &*quad : nullptr);
}

Replicates PixelEstimator::sumsOfTurns(const std::vector<Point>& points, std::uint32_t first, std::uint32_t turns) const
{
    Replicates sums;
    for (std::uint64_t replicate = 0; replicate < kReplicates; ++replicate)
        for (const Point& point : points)
            sums.values[replicate] += point.sumOfTurns(hashNumbers({point.key, replicate}), first, turns);
    return sums;
}

PixelReplicates PixelEstimator::replicates(int x, int y, int directions, std::uint64_t seed) const
{
    std::vector<Point> points;
    PixelEstimate exact;
    gather(x, y, seed, points, exact);
    const auto turns = static_cast<std::uint32_t>(directions / kDirectionsPerRound);
    PixelReplicates result = {sumsOfTurns(points, 0, turns), points.empty()};
    for (dvec3& color : result.colors.values)
        color = color / (double(turns) * kDirectionsPerTurn) + dvec3(exact.color);
    return result;
}

PixelReplicates PixelEstimator::wholePixel(int x, int y, int places, int turns) const
{
    PixelReplicates result = {{}, false};
    for (std::uint64_t replicate = 0; replicate < kReplicates; ++replicate) {
        const std::uint64_t key = hashNumbers({settings.seed, numberOf(x, y), replicate, ~std::uint64_t(0)});
        const ScrambledSequence sequence(key);
        std::vector<Point> points;
        PixelEstimate exact;
        for (int i = 0; i < places; ++i) {
            const dvec2 u = sequence[static_cast<std::uint32_t>(i)];
            gatherPlace(dvec2(x + 0.5 + filterPlace(u.x), y + 0.5 + filterPlace(u.y)), {x, y}, 1.0 / places,
                        hashNumbers({key, static_cast<std::uint64_t>(i)}), points, exact);
        }
        dvec3 sum(0.0);
        for (const Point& point : points)
            sum += point.sumOfTurns(point.key, 0, static_cast<std::uint32_t>(turns));
        result.colors.values[replicate] = dvec3(exact.color) + sum / (double(turns) * kDirectionsPerTurn);
    }
    return result;
}

PixelEstimate PixelEstimator::estimate(int x, int y, int directions, std::optional<double> target,
                                       double meanNorm) const
{
    std::vector<Point> points;
    PixelEstimate exact;
    gather(x, y, settings.seed, points, exact);
    if (points.empty())
        return exact;
    Replicates sums; // over all turns so far
    std::uint32_t turns = 0;
    for (auto goal = static_cast<std::uint32_t>(directions / kDirectionsPerRound);; goal *= 2) {
        const Replicates more = sumsOfTurns(points, turns, goal - turns);
        for (std::size_t i = 0; i < kReplicates; ++i)
            sums.values[i] += more.values[i];
        turns = goal;
        Replicates means = sums;
        for (dvec3& value : means.values)
            value /= double(turns) * kDirectionsPerTurn;
        PixelEstimate result = exact;
        result.color += dvec4(means.mean(), 0.0);
        result.variance = means.variance();
        result.directions = double(turns) * kDirectionsPerRound * static_cast<double>(points.size());
        const bool precise =
            !target || halfWidth95(result.variance) <= *target * (norm1(dvec3(result.color)) + 0.01 * meanNorm);
        if (precise || 2.0 * turns * kDirectionsPerRound > settings.maxDirections)
            return result;
    }
}

PixelEstimate PixelEstimator::estimate(int x, int y, double meanNorm) const
{
    return estimate(x, y, settings.directions, settings.targetError, meanNorm);
}

PixelEstimate PixelEstimator::pilot(int x, int y) const
{
    return estimate(x, y, kDirectionsPerRound, std::nullopt, 0.0);
}

} // namespace torrance
