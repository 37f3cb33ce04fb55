// Skins in the pose of rest.
#pragma once

#include "files/gltf_attributes.h"
#include "scene/scene.h"

namespace tinygltf {
class Model;
}

namespace torrance {

/// worldFromJoint * inverseBindMatrix of every joint of `skin`: from bind space straight to the world, since a skinned
/// mesh ignores the transform of its own node (glTF 2.0, 3.7.3.3). Errors (input): fewer matrices than joints, or of a
/// wrong type.
std::vector<dmat4> jointTransforms(const tinygltf::Model& model, int skin, const std::vector<dmat4>& worlds,
                                   const std::vector<GltfAccessor>& accessors, LoadReport& report);

/// Moves positions, normals and tangents into the world, all sets of JOINTS and WEIGHTS counted; the weights of a
/// vertex are scaled to a sum of one, and where all are zero its first joint moves it. Lengths of directions are not
/// kept. Errors (input): a joint that the skin does not have, attributes missing, a position that overflows.
void applySkin(Primitive& primitive, const GltfAttributes& attributes, const std::vector<dmat4>& joints,
               const std::string& item, const LoadReport& report);

} // namespace torrance
