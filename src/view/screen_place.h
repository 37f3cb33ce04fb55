// Between points of the world and pixels of a picture.
#pragma once

#include "scene/scene.h"

#include <optional>

namespace torrance {

/// Where a camera sees a point, in pixels from the picture's top left; nothing behind its near plane.
std::optional<dvec2> pixelOfPoint(const dvec3& point, const Camera& camera, const ivec2& pictureSize);

/// The point at the same depth that is seen so many pixels to the right and below.
dvec3 movedByPixels(const dvec3& point, const dvec2& pixels, const Camera& camera, const ivec2& pictureSize);

} // namespace torrance
