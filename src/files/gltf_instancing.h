// EXT_mesh_gpu_instancing: one mesh at many places.
#pragma once

#include "files/gltf_accessors.h"
#include "math/vector.h"

#include <optional>

namespace tinygltf {
class Node;
}

namespace torrance {

/// All instances of a file: a gigabyte of transforms is refused before it is made.
inline constexpr std::size_t kMaxInstances = std::size_t(1) << 22;

/// nodeFromInstance of every instance that the node's extension asks for, or nothing where it has none. Errors (input):
/// attributes of unequal counts or of formats that the extension does not allow.
std::optional<std::vector<dmat4>> instanceTransforms(const tinygltf::Node& node,
                                                     const std::vector<GltfAccessor>& accessors,
                                                     const std::string& item, GltfReport& report);

} // namespace torrance
