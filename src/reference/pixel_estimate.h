// One pixel of the reference, to a stated confidence.
#pragma once

#include "image/reconstruction.h"
#include "math/replicates.h"
#include "reference/reference_settings.h"
#include "reference/visible_surfaces.h"

#include <memory>

namespace torrance {

class PathTracer;

struct PixelEstimate
{
    dvec4 color = dvec4(0.0);    // scene-linear, premultiplied
    dvec3 variance = dvec3(0.0); // of the mean, per channel, estimated from kReplicates repetitions
    double directions = 0.0;     // drawn for it, all surfaces and replicates together
    double covered = 0.0;        // share of the pixel's samples that meet a surface
};

/// A pixel as kReplicates independent estimates of one mean: whoever judges a difference needs to know how it scatters,
/// not only how much.
struct PixelReplicates
{
    Replicates colors; // scene-linear, premultiplied: each unbiased
    bool exact = true; // all alike: nothing had to be estimated
};

/// A scene, seen by a camera, ready to be asked for any pixel. Any number of threads may ask; what a pixel holds
/// depends on its place and the settings alone.
class PixelEstimator
{
public:
    /// Keeps references to scene and settings.
    PixelEstimator(const Scene& scene, const Camera& camera, const ReferenceSettings& settings);
    PixelEstimator(const PixelEstimator&) = delete; // it refers to itself
    PixelEstimator& operator=(const PixelEstimator&) = delete;
    ~PixelEstimator();

    /// `meanNorm` is the mean |c|_1 of the covered pixels, one hundredth of which the target error adds to a pixel's
    /// own; read where there is a target.
    PixelEstimate estimate(int x, int y, double meanNorm) const;

    /// The same from the fewest directions that there can be: to know about how bright the picture is.
    PixelEstimate pilot(int x, int y) const;

    /// `directions` of a pixel per surface point and light that is no point, a multiple of kDirectionsPerRound. Of
    /// different seeds they are independent.
    PixelReplicates replicates(int x, int y, int directions, std::uint64_t seed) const;

    /// The whole pixel, in place of the places that the settings take of it: each replicate has `places` of its own,
    /// random and even, by the reconstruction filter, and `turns` of directions at each.
    PixelReplicates wholePixel(int x, int y, int places, int turns) const;

    /// The ray through a place in the picture, in pixels from its top-left corner.
    Ray rayAt(double x, double y) const;
    /// The surfaces under it, as a place of this pixel.
    VisibleSurfaces surfacesAt(const dvec2& place, const ivec2& pixel) const;
    /// What the pixel's centre sees first; a pixel is covered where that is something.
    std::optional<Hit> seenFrom(int x, int y) const;

    const RayCaster& rays() const { return caster; }
    /// Null where it is dark.
    const EnvironmentSampler* surroundings() const { return environment ? &*environment : nullptr; }

private:
    struct Point;
    PixelEstimate estimate(int x, int y, int directions, std::optional<double> halfWidth, double meanNorm) const;
    void gather(int x, int y, std::uint64_t seed, std::vector<Point>& points, PixelEstimate& exact) const;
    void gatherPlace(const dvec2& place, const ivec2& pixel, double weight, std::uint64_t key,
                     std::vector<Point>& points, PixelEstimate& exact) const;
    std::uint64_t numberOf(int x, int y) const;
    void addSurface(const VisibleSurface& seen, double share, std::uint64_t key, std::vector<Point>& points,
                    PixelEstimate& exact) const;
    Replicates sumsOfTurns(const std::vector<Point>& points, std::uint32_t first, std::uint32_t turns) const;
    dvec4 backgroundOf(const Ray& ray) const;
    std::optional<QuadRays> quadOf(const dvec2& place, const ivec2& pixel) const;

    const ReferenceSettings& settings;
    std::optional<InterfaceAlbedo> interfaceAlbedo; // of the yardstick physics
    Yardstick yardstick;
    Camera camera;
    RayCaster caster;
    std::vector<dvec2> offsets;
    bool holes;                                    // some material lets others through
    std::vector<Light> exactLights;                // whose light on a point is one evaluation
    std::vector<Light> estimatedLights;            // the others
    std::optional<EnvironmentSampler> environment; // where it is not dark
    std::unique_ptr<PathTracer> paths;             // of transport
};

} // namespace torrance
