// Pictures of meshes, ray-cast on the CPU.
#pragma once

#include "drawing.h"
#include "reference/material_point.h"

#include <vector>

namespace torrance::test {

struct CastPixel
{
    bool covered = false;
    bool nearEdge = false; // the 3 x 3 neighbourhood sees more than one surface, or one and the background
    dvec3 radiance = dvec3(0.0);
    SurfacePoint surface; // where covered
    MaterialPoint material;
};

/// Through the pixels' centres, row by row; opaque and masked materials, punctual lights, uniform environments.
std::vector<CastPixel> castPicture(const Scene& scene, const brdf::Preset& methods, const Camera& camera, int width,
                                   int height);

/// How a drawn picture agrees with a cast one, over the covered pixels away from edges. The error of a pixel is |d -
/// c|_1 /
/// (|c|_1 + 1 % of the mean |c|_1).
struct Agreement
{
    int compared = 0;
    int coverageErrors = 0; // away from edges: covered in one picture only
    double percentile99 = 0.0;
    WorstExcess worst; // in units of `tolerance`
};

Agreement compareToCast(const Picture& picture, const std::vector<CastPixel>& cast, double tolerance);

/// Draws the scene, casts it, and expects 99 % of the pixels within `tolerance` and no difference of coverage.
void expectDrawnAsCast(const Scene& scene, const Camera& camera, const Settings& settings, double tolerance,
                       const std::string& name);

} // namespace torrance::test
