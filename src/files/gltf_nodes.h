// The node hierarchy: a forest, and where each node stands in the world.
#pragma once

#include "files/load_report.h"
#include "math/vector.h"

#include <nlohmann/json_fwd.hpp>

namespace tinygltf {
class Model;
class Node;
} // namespace tinygltf

namespace torrance {

struct GltfNodeTree
{
    std::vector<int> parents;     // -1 = a root
    std::vector<int> parentFirst; // all nodes, each after its parent
};

/// Of a document that passed checkSchema. Errors (input): a node with two parents or below itself. Walks without
/// recursion: a chain of a million nodes is no deeper than one.
GltfNodeTree checkNodeTree(const nlohmann::json& document, const LoadReport& report);

/// glTF 2.0, 3.5.2: the matrix, or translation * rotation * scale. Rotations are normalised; one that is far from unit
/// length is a warning, one of length zero or a matrix that is no affine map an error (input).
dmat4 localTransform(const tinygltf::Node& node, const std::string& item, LoadReport& report);

/// worldFromNode of every node, whatever scene holds it. An Error (input) where one overflows.
std::vector<dmat4> worldTransforms(const tinygltf::Model& model, const GltfNodeTree& tree, LoadReport& report);

/// The nodes of a scene in document order, parents before children, each once.
std::vector<int> nodesOfScene(const tinygltf::Model& model, const std::vector<int>& roots);

} // namespace torrance
