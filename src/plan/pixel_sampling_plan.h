// How many pictures a frame draws for its samples, and what one shading a pixel cannot do.
#pragma once

#include "plan/shading_plan.h"

namespace torrance {

/// True where every pixel is shaded once and its samples know depth alone.
bool shadesOncePerPixel(const Settings& settings);

/// Pictures whose mean is the result.
int pictureCount(const Settings& settings);

/// Throws Error (usage) for `reconstructed` with another number of samples than 4, or with analytic shapes.
void checkPixelSampling(const ShadingPlan& plan);

} // namespace torrance
