#include "study/unvouched.h"

#include "core/parallel.h"
#include "math/frame.h"
#include "math/sampling.h"
#include "math/scrambled_sequence.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace torrance {
namespace {

/// Rays per place into the hemisphere: a surface that fills a tenth of the sky is missed at a place with probability
/// 0.9^16 = 0.19, and at all of some dozens never.
constexpr std::uint32_t kRays = 16;
/// Hits nearer than this share of the eye's distance are the surface itself: float vertices of Embree round by 6e-8.
constexpr double kOwnSurface = 1e-4;

struct Seen
{
    bool surface = false; // there is one
    bool shadow = false;  // a lamp is behind another
    bool others = false;  // another fills a part of the sky
};

bool isOccluder(const RayCaster& rays, const SurfacePoint& from, const dvec3& direction, double farthest)
{
    const double step = kOwnSurface * from.distance;
    const auto hit = rays.closest({from.position + step * from.geometricNormal, direction}, step);
    return hit && hit->distance < farthest;
}

bool isShadowed(const RayCaster& rays, const SurfacePoint& point)
{
    return std::ranges::any_of(rays.scene().lights, [&](const Light& light) {
        const LightSample sample = sampleLight(light, rays.origin(), point.position);
        const double distance = light.kind == Light::Kind::directional
                                    ? std::numeric_limits<double>::infinity()
                                    : glm::length(light.position - rays.origin() - point.position) - light.radius;
        return sample.irradiance != dvec3(0.0) && glm::dot(sample.direction, point.geometricNormal) > 0.0 &&
               isOccluder(rays, point, sample.direction, distance);
    });
}

bool seesOthers(const RayCaster& rays, const SurfacePoint& point, std::uint64_t key)
{
    const dmat3 axes = frameAround(point.geometricNormal);
    const ScrambledSequence sequence(hashNumbers({key}));
    for (std::uint32_t i = 0; i < kRays; ++i)
        if (isOccluder(rays, point, axes * sampleCosine(sequence[i]), std::numeric_limits<double>::infinity()))
            return true;
    return false;
}

std::size_t count(const std::vector<Seen>& seen, bool Seen::*what)
{
    return static_cast<std::size_t>(std::ranges::count_if(seen, [&](const Seen& s) { return s.*what; }));
}

} // namespace

std::vector<std::string> unvouchedEffects(const PixelEstimator& estimator, bool samplingIsVouched,
                                          bool transportIsVouched, std::span<const dvec2> places)
{
    const RayCaster& rays = estimator.rays();
    std::vector<Seen> seen(places.size());
    parallelFor(places.size(), 8, [&](std::size_t i) {
        const VisibleSurfaces surfaces = estimator.surfacesAt(places[i], ivec2(places[i]));
        if (surfaces.surfaces.empty())
            return;
        const SurfacePoint& point = surfaces.surfaces.front().surface;
        seen[i] = {true, isShadowed(rays, point), seesOthers(rays, point, i)};
    });
    std::vector<std::string> effects;
    const std::size_t all = count(seen, &Seen::surface);
    if (const std::size_t n = count(seen, &Seen::shadow); n > 0 && !transportIsVouched)
        effects.push_back(fmt::format("transport: shadows of lamps, at {} of {} pixels", n, all));
    if (const std::size_t n = count(seen, &Seen::others); n > 0 && !transportIsVouched)
        effects.push_back(
            fmt::format("transport: {} of {} pixels see other surfaces, whose shadow in the environment's "
                        "light and whose own light are not traced",
                        n, all));
    if (!samplingIsVouched)
        effects.emplace_back("sampling: pixel and texture filtering; --certify=sampling adds it");
    std::size_t thin = 0;
    for (const Instance& instance : rays.scene().instances)
        thin += rays.scene().primitives[static_cast<std::size_t>(instance.primitive)].topology != Topology::triangles;
    if (thin > 0)
        effects.push_back(fmt::format("surface: {} primitives of points or lines, which rays do not meet", thin));
    return effects;
}

} // namespace torrance
