// One pixel of the reference, to a stated confidence.
#pragma once

#include "image/reconstruction.h"
#include "reference/reference_settings.h"
#include "reference/visible_surfaces.h"

namespace torrance {

struct PixelEstimate
{
    dvec4 color = dvec4(0.0);    // scene-linear, premultiplied
    dvec3 variance = dvec3(0.0); // of the mean, per channel, estimated from kReplicates repetitions
    double directions = 0.0;     // drawn for it, all surfaces and replicates together
    double covered = 0.0;        // share of the pixel's samples that meet a surface
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

    /// `meanNorm` is the mean |c|_1 of the covered pixels, one hundredth of which the target error adds to a pixel's
    /// own; read where there is a target.
    PixelEstimate estimate(int x, int y, double meanNorm) const;

    /// The same from the fewest directions that there can be: to know about how bright the picture is.
    PixelEstimate pilot(int x, int y) const;

private:
    struct Point;
    PixelEstimate estimate(int x, int y, int directions, std::optional<double> halfWidth, double meanNorm) const;
    void gather(int x, int y, std::vector<Point>& points, PixelEstimate& exact) const;
    void addSurface(const VisibleSurface& seen, double share, std::uint64_t key, std::vector<Point>& points,
                    PixelEstimate& exact) const;
    dvec4 backgroundOf(const Ray& ray) const;

    const ReferenceSettings& settings;
    std::optional<InterfaceAlbedo> interfaceAlbedo; // of the yardstick physics
    Yardstick yardstick;
    Camera camera;
    RayCaster caster;
    std::vector<dvec2> offsets;
    std::vector<Light> exactLights;                // whose light on a point is one evaluation
    std::vector<Light> estimatedLights;            // the others
    std::optional<EnvironmentSampler> environment; // where it is not dark
};

} // namespace torrance
