// Lamps that turn about the scene while they are looked at.
#pragma once

#include "scene/scene.h"

#include <span>

namespace torrance {

/// Turns places and directions about the axis +Y through `center`, counter-clockwise seen from above.
void turnLights(std::span<Light> lights, const dvec3& center, double degrees);

} // namespace torrance
