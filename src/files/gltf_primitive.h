// One mesh primitive of glTF as a Primitive of the scene.
#pragma once

#include "files/gltf_accessors.h"
#include "files/scene_file.h"
#include "scene/scene.h"

#include <array>
#include <optional>

namespace tinygltf {
class Model;
}

namespace torrance {

struct GltfGeometry
{
    const tinygltf::Model& model;
    const std::vector<GltfAccessor>& accessors;
    const SceneLimits& limits;
    bool quantizationDeclared = false;
    std::size_t vertices = 0; // read so far
    std::size_t indices = 0;
};

/// How a use of a mesh wants its primitives.
struct GltfPose
{
    std::vector<double> weights;                // of morph targets; empty = none
    const std::vector<dmat4>* joints = nullptr; // of the skin, from bind space to the world
};

/// Primitive `number` of mesh `mesh`, posed, with lists for indices, unit normals (flat ones where the file has none)
/// and bounds. `uvSets` are the file's texture coordinate sets that become uvs[0] and uvs[1]; `textured` says which of
/// them the material samples: one that is missing is filled with zeros, with a warning. `material` is left to the
/// caller. Nothing where there are no positions or where no point, line or triangle comes out (a warning). Errors
/// (input): whatever glTF does not allow, an index past the vertices, more than the limits.
std::optional<Primitive> readPrimitive(GltfGeometry& geometry, int mesh, std::size_t number, const GltfPose& pose,
                                       const std::array<int, 2>& uvSets, const std::array<bool, 2>& textured,
                                       LoadReport& report);

} // namespace torrance
