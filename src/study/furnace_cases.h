// The white furnace: spheres of a white material in an environment of radiance 1 return what the model says, no more
// and no less.
#pragma once

#include "study/picture_case.h"

#include <vector>

namespace torrance {

/// A sphere per roughness, with `name` in its name. A pixel should be what the integral of the model says; where
/// multiple scattering is compensated, white metal returns all light, 1.
std::vector<PictureCase> furnaceCases(const brdf::Preset& methods, std::string_view name, double metallic);
std::vector<PictureCase> furnaceCases(std::string_view preset, double metallic);

} // namespace torrance
