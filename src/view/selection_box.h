// The box round what is selected, as lines over the picture.
#pragma once

#include "scene/scene.h"

#include <vector>

namespace torrance {

struct ScreenLine
{
    dvec2 begin, end; // pixels from the picture's top left
};

/// The edges of an instance's box, along the axes of its own space, as a camera sees them: parts behind the near plane
/// are cut off.
std::vector<ScreenLine> selectionBox(const Scene& scene, int instance, const Camera& camera, const ivec2& pictureSize);

} // namespace torrance
