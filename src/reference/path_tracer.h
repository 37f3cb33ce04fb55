// Light that reaches the eye over any number of surfaces: shadows and interreflection.
#pragma once

#include "reference/emitters.h"
#include "reference/light_integral.h"
#include "reference/path_rays.h"
#include "reference/visible_surfaces.h"

#include <vector>

namespace torrance {

struct PathNumbers;
struct PathVertex;

/// So many surfaces of a path reflect without a draw of whether it goes on (Russian roulette): what most of the light
/// goes over is not made noisier.
inline constexpr int kSureSurfaces = 2;

/// A path goes on with at most this probability, so that it ends almost surely where nothing is absorbed, too. What it
/// carries is divided by it: n surfaces of albedo rho carry rho^n and are survived with 0.999^n, so that the variance
/// is finite where rho^2 is below 0.999.
inline constexpr double kMostSurvival = 0.999;

/// The light of a scene, by paths from the eye that are drawn from both ends (Veach & Guibas, Optimally Combining
/// Sampling Techniques for Monte Carlo Rendering, 1995): at each surface a direction towards a light is drawn, and one
/// in which the path goes on, and what both of them can find counts by the balance heuristic. Any number of threads may
/// ask; what a path carries depends on its key and number alone.
class PathTracer
{
public:
    /// Keeps references; `environment` is null where it is dark. Of the choice: `combined` both, `brdf` finds lights by
    /// going on alone, `light` by what is drawn from them, where that finds them. Lights that are points, which no
    /// direction meets, are always asked.
    PathTracer(const RayCaster& caster, const Yardstick& yardstick, const EnvironmentSampler* environment,
               DirectionChoice choice);

    /// What a surface sends to the eye that needs no path: what it emits, and the light of points where the yardstick
    /// is exact, less their shadows.
    dvec3 exactLight(const VisibleSurface& seen) const;

    /// The rest of what it sends: the sum of the paths of turns [first, first + turns) of `key`, kDirectionsPerTurn
    /// each. The light is the sum over their number.
    dvec3 sumOfTurns(const VisibleSurface& seen, std::uint64_t key, std::uint32_t first, std::uint32_t turns) const;

private:
    struct Bounce
    {
        dvec3 direction;
        double density;
    };
    dvec3 path(const VisibleSurface& seen, const PathNumbers& first, NumberStream& stream) const;
    dvec3 lightAt(const PathVertex& vertex, const PathNumbers& numbers, bool byEye) const;
    dvec3 drawnEnvironment(const PathVertex& vertex, const PathNumbers& numbers) const;
    dvec3 drawnEmitter(const PathVertex& vertex, const PathNumbers& numbers) const;
    dvec3 drawnSphere(const PathVertex& vertex, const PathNumbers& numbers) const;
    dvec3 drawnPoint(const PathVertex& vertex, const PathNumbers& numbers) const;
    dvec3 pointLight(const PathVertex& vertex, const Light& light) const;
    dvec3 spheresMet(const PathVertex& vertex, const Bounce& bounce, double farthest) const;
    dvec3 contribution(const PathVertex& vertex, const dvec3& direction, const DirectedLight& light,
                       std::uint64_t key) const;
    double weightOfBounce(double bounce, double light) const;
    std::vector<double> sharesOf(const PathVertex& vertex, const std::vector<Light>& lights) const;

    PathRays rays;
    Yardstick yardstick;
    const EnvironmentSampler* environment;
    DirectionChoice choice;
    Emitters emitters;
    std::vector<Light> points;  // lights without a size
    std::vector<Light> spheres; // lights with a radius
};

/// The light of one visible surface, as PixelEstimator sums it up.
struct PathIntegral
{
    const PathTracer& tracer;
    VisibleSurface seen;

    dvec3 sumOfTurns(std::uint64_t key, std::uint32_t first, std::uint32_t turns) const
    {
        return tracer.sumOfTurns(seen, key, first, turns);
    }
};

/// A light with a radius: drawn from, and met, as the sphere that it is.
inline bool isSphere(const Light& light)
{
    return light.radius > 0.0 && light.kind != Light::Kind::directional;
}

} // namespace torrance
