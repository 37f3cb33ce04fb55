#include "reference/pixel_estimate.h"

#include "reference/shade.h"
#include "reference/visible_surfaces.h"
#include "scene/camera_view.h"

namespace torrance {

/// A surface point that the environment lights, with its share of the pixel.
struct PixelEstimator::Point
{
    EnvironmentIntegral integral;
    double share;
    std::uint64_t key;
};

PixelEstimator::PixelEstimator(const Scene& scene, const Camera& c, const ReferenceSettings& s)
    : settings(s), camera(c), caster(scene, cameraPosition(c)), offsets(sampleOffsets(s.pixelSamples))
{
    if (!scene.environment)
        return;
    environment.emplace(*scene.environment);
    if (environment->dark())
        environment.reset();
}

dvec4 PixelEstimator::backgroundOf(const Ray& ray) const
{
    if (settings.background)
        return *settings.background;
    return environment ? dvec4(environment->at(ray.direction).radiance, 1.0) : dvec4(0.0, 0.0, 0.0, 1.0);
}

void PixelEstimator::gather(int x, int y, std::vector<Point>& points, PixelEstimate& exact) const
{
    const Scene& scene = caster.scene();
    const Illumination lights{scene.lights};
    const double weight = 1.0 / static_cast<double>(offsets.size());
    const std::uint64_t pixel =
        static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(settings.width) + static_cast<std::uint64_t>(x);
    for (std::size_t sample = 0; sample < offsets.size(); ++sample) {
        const Ray ray = primaryRay(camera, settings.width, settings.height, x + 0.5 + offsets[sample].x,
                                   y + 0.5 + offsets[sample].y);
        const VisibleSurfaces seen = visibleSurfaces(caster, ray);
        for (std::size_t i = 0; i < seen.surfaces.size(); ++i) {
            const auto& [surface, material, alpha] = seen.surfaces[i];
            const double share = weight * alpha;
            exact.color +=
                share *
                dvec4(shade(settings.methods, lights, material, caster.origin(), surface.position, surface.view), 1.0);
            if (environment && !material.unlit && material.occlusion != 0.0)
                points.push_back(
                    {EnvironmentIntegral(settings.methods, *environment, material, surface.view, settings.choice),
                     share, hashNumbers({pixel, sample, i})});
        }
        exact.covered += seen.surfaces.empty() ? 0.0 : weight;
        exact.color += weight * seen.through * backgroundOf(ray);
    }
}

namespace {

/// |c|_1, as the error of a pixel counts.
double norm1(const dvec4& color)
{
    return std::abs(color.r) + std::abs(color.g) + std::abs(color.b);
}

} // namespace

PixelEstimate PixelEstimator::estimate(int x, int y, int directions, std::optional<double> target,
                                       double meanNorm) const
{
    std::vector<Point> points;
    PixelEstimate exact;
    gather(x, y, points, exact);
    if (points.empty())
        return exact;
    Replicates sums; // over all turns so far
    std::uint32_t turns = 0;
    for (auto goal = static_cast<std::uint32_t>(directions / kDirectionsPerRound);; goal *= 2) {
        for (std::uint64_t replicate = 0; replicate < kReplicates; ++replicate)
            for (const Point& point : points)
                sums.values[replicate] +=
                    point.share * point.integral.sumOfTurns(hashNumbers({point.key, replicate}), turns, goal - turns);
        turns = goal;
        Replicates means = sums;
        for (dvec3& value : means.values)
            value /= double(turns) * kDirectionsPerTurn;
        PixelEstimate result = exact;
        result.color += dvec4(means.mean(), 0.0);
        result.variance = means.variance();
        result.directions = double(turns) * kDirectionsPerRound * static_cast<double>(points.size());
        const bool precise =
            !target || halfWidth95(result.variance) <= *target * (norm1(result.color) + 0.01 * meanNorm);
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
