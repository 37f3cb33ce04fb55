// The white furnace: spheres of a white material in an environment of radiance 1 return what the model says, no more
// and no less.
#pragma once

#include "study/picture_case.h"

#include <vector>

namespace torrance {

/// A sphere per roughness. In `gltf` a pixel should be what the integral of the model says; white metal in `standard`
/// returns all light, 1.
std::vector<PictureCase> furnaceCases(std::string_view preset, double metallic);

} // namespace torrance
