// How far a drawing of the sphere set lies from its truth.
#pragma once

#include "study/sphere_truth.h"

namespace torrance {

struct SphereJudgement
{
    MethodError error;
    Image pixels; // one channel: of each pixel |d - c|_1 / (|c|_1 + 1 % of the mean |c|_1), 0 where none counts
};

/// `drawn` has the set's size and at least three channels, scene-linear. Pixels that are not finite count as infinitely
/// wrong.
SphereJudgement judgeSpheres(const MethodGrid& grid, const SphereTruth& truth, const Image& drawn);

} // namespace torrance
