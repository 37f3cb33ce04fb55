// KHR_lights_punctual.
#pragma once

#include "files/load_report.h"
#include "scene/scene.h"

namespace tinygltf {
class Model;
}

namespace torrance {

/// Light `index` of the file on a node at `world`: it shines along the node's -Z. Scale changes neither its intensity
/// nor its range. Errors (input): an unknown type, cone angles without 0 <= inner < outer <= pi/2, a range that is not
/// above zero, an extras.radius (metres, point and spot lights) that is no length. Negative intensities and colours
/// become zero with a warning.
Light readLight(const tinygltf::Model& model, std::size_t index, const dmat4& world, LoadReport& report);

} // namespace torrance
