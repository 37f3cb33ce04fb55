// The exact light of the surfaces that a device found under its pixels' centres: what shading error is measured
// against. Triangles and texels are the device's own, and its level of detail is one where `picture` was
// drawn with trilinear_exact: what other filters change is their error.
#pragma once

#include "math/replicates.h"
#include "passes/renderer.h"

namespace torrance {

struct SurfaceTruth
{
    // Row by row.
    std::vector<Replicates> light; // independent estimates, scene-linear; 0 where nothing counts
    std::vector<bool> counted;     // pixels with a surface that is not blended
};

/// `picture` was drawn with Settings::layers. Light from all around and from lights with a radius by `directions` each,
/// a multiple of 64. `checkpoint` is called by any thread, and may not throw: true ends the work early.
SurfaceTruth surfaceTruth(const Scene& scene, const Camera& camera, const brdf::Preset& methods, const Picture& picture,
                          int directions, const std::function<bool()>& stop);

} // namespace torrance
