// Light whose direction and distance are the same for every point of a scene.
#pragma once

#include "scene/scene.h"

namespace torrance {

/// Light of radiant intensity `intensity` from `distance` metres away along `towards` (any length but 0), as every
/// point sees it: irradiance intensity / distance^2. It is a directional light of that illuminance. distance > 0.
Light constantLight(const dvec3& towards, double distance, double intensity);

} // namespace torrance
