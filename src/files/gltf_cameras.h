// Cameras of glTF.
#pragma once

#include "files/load_report.h"
#include "scene/scene.h"

namespace tinygltf {
class Model;
}

namespace torrance {

/// Camera `index` of the file on a node at `world`. The node's scale and shear are left out (glTF 2.0, 3.10.2): -Z
/// stays the direction of view, +Y is made perpendicular to it. Errors (input): an angle, extent or plane without
/// meaning.
Camera readCamera(const tinygltf::Model& model, std::size_t index, const dmat4& world, LoadReport& report);

} // namespace torrance
