// The surface parameters that a layers pass wrote, as named pictures.
#pragma once

#include "passes/renderer.h"

#include <span>

namespace torrance {

/// From the targets of shaders/passes/surface_layers.frag. Positions become the world's: `eye` is added in double.
/// Nothing covered: 0 everywhere; ids count from 1.
std::vector<Layer> splitLayers(std::span<const Image> targets, const dvec3& eye);

} // namespace torrance
