// Morph targets at the weights of rest.
#pragma once

#include "files/gltf_attributes.h"
#include "scene/scene.h"

namespace tinygltf {
struct Primitive;
}

namespace torrance {

struct GltfGeometry;

/// Adds the targets' POSITION, NORMAL and TANGENT differences, each times its weight (glTF 2.0, 3.7.2.2), summed in
/// double. Normals and tangents are left as they come out, not yet of unit length. `weights` has one number for each
/// target. Differences of other attributes are left out with a warning. Errors (input): a number
/// of weights or elements that does not fit, a sum that overflows.
void applyMorphTargets(Primitive& primitive, const tinygltf::Primitive& source, const std::vector<double>& weights,
                       const GltfGeometry& geometry, const std::string& item, LoadReport& report);

} // namespace torrance
