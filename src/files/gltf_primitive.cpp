#include "files/gltf_primitive.h"

#include "files/gltf_attributes.h"
#include "files/gltf_elements.h"
#include "files/gltf_model.h"
#include "files/gltf_morph.h"
#include "files/gltf_normals.h"
#include "files/gltf_skin.h"
#include "files/gltf_topology.h"
#include "scene/primitive_bounds.h"

#include <numeric>

namespace torrance {
namespace {

/// Adds to what was read so far, before anything is allocated for it.
void charge(std::size_t& soFar, std::size_t count, std::size_t most, const char* what, const std::string& item,
            const LoadReport& report)
{
    if (count > most || soFar > most - count)
        report.fail(item, "brings the file to more than " + std::to_string(most) + " " + what, "split the model");
    soFar += count;
}

std::size_t vertexCount(const GltfGeometry& geometry, const tinygltf::Primitive& source)
{
    const auto position = source.attributes.find("POSITION");
    return position == source.attributes.end() ? 0
                                               : geometry.accessors[static_cast<std::size_t>(position->second)].count;
}

std::vector<std::uint32_t> readIndexList(GltfGeometry& geometry, const tinygltf::Primitive& source,
                                         std::size_t vertices, const std::string& item, const LoadReport& report)
{
    const GltfAccessor* accessor =
        source.indices < 0 ? nullptr : &geometry.accessors[static_cast<std::size_t>(source.indices)];
    const std::size_t count = accessor == nullptr ? vertices : accessor->count;
    charge(geometry.indices, std::max(unrolledCount(source.mode, count), count), geometry.limits.indices, "indices",
           item, report);

    std::vector<std::uint32_t> indices;
    if (accessor == nullptr) {
        indices.resize(count);
        std::iota(indices.begin(), indices.end(), 0u);
        return indices;
    }
    const bool isUnsigned = accessor->component == ComponentType::uint8 ||
                            accessor->component == ComponentType::uint16 ||
                            accessor->component == ComponentType::uint32;
    if (!accessor->isVector(1) || !isUnsigned || accessor->normalized)
        report.fail(item + "/indices", "are not scalars of an unsigned integer type", kRepair);
    indices = readIndices(*accessor);
    for (std::size_t i = 0; i < indices.size(); ++i)
        if (indices[i] >= vertices)
            report.fail(item + "/indices",
                        "refer to vertex " + std::to_string(indices[i]) + " of " + std::to_string(vertices) + " at " +
                            std::to_string(i),
                        kRepair);
    return indices;
}

void readUvs(Primitive& primitive, const GltfAttributes& attributes, const std::array<int, 2>& uvSets,
             const std::array<bool, 2>& textured, const std::string& item, LoadReport& report)
{
    for (std::size_t slot = 0; slot < 2; ++slot) {
        primitive.uvs[slot] = attributes.read<2>("TEXCOORD_" + std::to_string(uvSets[slot]));
        if (!primitive.uvs[slot].empty() || !textured[slot])
            continue;
        report.warn(item,
                    "is textured by TEXCOORD_" + std::to_string(uvSets[slot]) + ", which it does not have: 0 is used");
        primitive.uvs[slot].assign(primitive.positions.size(), vec2(0.0f));
    }
}

void readVertices(Primitive& primitive, const GltfAttributes& attributes, const std::array<int, 2>& uvSets,
                  const std::array<bool, 2>& textured, const std::string& item, LoadReport& report)
{
    primitive.positions = attributes.read<3>("POSITION");
    primitive.normals = attributes.read<3>("NORMAL");
    primitive.tangents = attributes.read<4>("TANGENT");
    primitive.colors = attributes.read<4>("COLOR_0");
    readUvs(primitive, attributes, uvSets, textured, item, report);
}

void finishDirections(Primitive& primitive, const std::string& item, LoadReport& report)
{
    if (primitive.normals.empty()) {
        primitive.tangents.clear(); // glTF 2.0, 3.7.2.1: tangents without normals are ignored
        if (primitive.topology == Topology::triangles)
            makeFlat(primitive);
        return;
    }
    if (const std::size_t repaired = normalizeNormals(primitive); repaired > 0)
        report.warn(item, "has " + std::to_string(repaired) + " normals of no direction, computed from its triangles");
    if (!normalizeTangents(primitive)) {
        report.warn(item, "has tangents of no direction: all of its tangents are computed");
        primitive.tangents.clear();
    }
}

std::string nameOf(const tinygltf::Mesh& mesh, int index, std::size_t number)
{
    const std::string name = mesh.name.empty() ? "mesh " + std::to_string(index) : mesh.name;
    return mesh.primitives.size() == 1 ? name : name + " " + std::to_string(number);
}

} // namespace

std::optional<Primitive> readPrimitive(GltfGeometry& geometry, int meshIndex, std::size_t number, const GltfPose& pose,
                                       const std::array<int, 2>& uvSets, const std::array<bool, 2>& textured,
                                       LoadReport& report)
{
    const tinygltf::Mesh& mesh = geometry.model.meshes[static_cast<std::size_t>(meshIndex)];
    const tinygltf::Primitive& source = mesh.primitives[number];
    const std::string item =
        itemName("meshes", static_cast<std::size_t>(meshIndex)) + "/primitives/" + std::to_string(number);
    if (source.mode < 0 || source.mode >= kGltfModes)
        report.fail(item, "has the unknown mode " + std::to_string(source.mode), kRepair);
    const std::size_t vertices = vertexCount(geometry, source);
    if (vertices == 0) {
        report.warn(item, "has no positions and is left out");
        return std::nullopt;
    }
    charge(geometry.vertices, vertices, geometry.limits.vertices, "vertices", item, report);
    const GltfAttributes attributes(source.attributes, geometry.accessors, vertices, geometry.quantizationDeclared,
                                    item, report);

    Primitive primitive;
    primitive.name = nameOf(mesh, meshIndex, number);
    primitive.topology = topologyOfMode(source.mode);
    primitive.indices = unrolled(source.mode, readIndexList(geometry, source, vertices, item, report));
    if (primitive.indices.empty()) {
        report.warn(item, "has too few vertices for its mode and is left out");
        return std::nullopt;
    }
    readVertices(primitive, attributes, uvSets, textured, item, report);
    if (!pose.weights.empty())
        applyMorphTargets(primitive, source, pose.weights, geometry, item, report);
    if (pose.joints != nullptr)
        applySkin(primitive, attributes, *pose.joints, item, report);
    if (primitive.normals.empty() && primitive.topology == Topology::triangles)
        charge(geometry.vertices, primitive.indices.size(), geometry.limits.vertices, "vertices", item, report);
    finishDirections(primitive, item, report);
    setBounds(primitive);
    return primitive;
}

} // namespace torrance
