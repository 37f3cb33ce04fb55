// EXT_mesh_gpu_instancing: one mesh at many places.
#pragma once

#include "files/gltf_accessors.h"
#include "math/vector.h"

#include <optional>

namespace tinygltf {
class Node;
}

namespace torrance {

/// nodeFromInstance of every instance that the node's extension asks for, or nothing where it has none. Errors (input):
/// attributes of unequal counts, of formats that the extension does not allow, more than `most` instances.
std::optional<std::vector<dmat4>> instanceTransforms(const tinygltf::Node& node,
                                                     const std::vector<GltfAccessor>& accessors, std::size_t most,
                                                     const std::string& item, LoadReport& report);

} // namespace torrance
