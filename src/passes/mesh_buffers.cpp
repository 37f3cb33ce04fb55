#include "passes/mesh_buffers.h"

#include "scene/tangents.h"

#include <algorithm>
#include <cstring>
#include <map>

namespace torrance {
namespace {

// One growing array of bytes that becomes a buffer.
class ByteStream
{
public:
    template <typename T>
    vk::DeviceSize append(const std::vector<T>& items)
    {
        const vk::DeviceSize offset = bytes.size();
        const auto view = std::as_bytes(std::span(items));
        bytes.insert(bytes.end(), view.begin(), view.end());
        return offset;
    }
    std::vector<std::byte> bytes;
};

dvec3 centerToRemove(const Primitive& primitive)
{
    const dvec3 center = 0.5 * (primitive.boundsMin + primitive.boundsMax);
    const double size = glm::length(primitive.boundsMax - primitive.boundsMin);
    return glm::length(center) > kRecentreRatio * size ? center : dvec3(0.0);
}

std::vector<vec3> recentred(const std::vector<vec3>& positions, const dvec3& center)
{
    if (center == dvec3(0.0))
        return positions;
    std::vector<vec3> moved;
    moved.reserve(positions.size());
    for (const vec3& p : positions)
        moved.emplace_back(dvec3(p) - center);
    return moved;
}

// Which normal map decides a primitive's tangents; null where no shader of the plan reads any.
std::map<int, const TextureUse*> tangentSources(const Scene& scene, const ShadingPlan& plan)
{
    std::map<int, const TextureUse*> sources; // by primitive, for all that are drawn
    for (const auto* list : {&plan.batches, &plan.blended})
        for (const Batch& batch : *list)
            for (const Draw& draw : batch.draws) {
                if (draw.primitive < 0)
                    continue;
                const int material = plan.instances[static_cast<std::size_t>(draw.firstInstance)].material;
                const Primitive& primitive = scene.primitives[static_cast<std::size_t>(draw.primitive)];
                const bool missing = batch.key.tangents() && primitive.tangents.empty();
                sources[draw.primitive] =
                    missing ? &plan.materials[static_cast<std::size_t>(material)].material.normal : nullptr;
            }
    return sources;
}

PrimitiveRange append(const Primitive& primitive, ByteStream& vertices, ByteStream& indices)
{
    PrimitiveRange range;
    range.center = centerToRemove(primitive);
    range.streams = {vertices.append(recentred(primitive.positions, range.center)),
                     vertices.append(primitive.normals),
                     vertices.append(primitive.tangents),
                     vertices.append(primitive.uvs[0]),
                     vertices.append(primitive.uvs[1]),
                     vertices.append(primitive.colors)};
    range.vertexCount = static_cast<std::uint32_t>(primitive.positions.size());
    range.indexCount = static_cast<std::uint32_t>(primitive.indices.size());
    range.firstIndex = static_cast<std::uint32_t>(indices.append(primitive.indices) / sizeof(std::uint32_t));
    return range;
}

} // namespace

MeshBuffers makeMeshBuffers(const gpu::Device& device, const Scene& scene, const ShadingPlan& plan)
{
    ByteStream vertices, indices;
    MeshBuffers buffers;
    buffers.ranges.resize(scene.primitives.size());
    for (const auto& [index, normalMap] : tangentSources(scene, plan)) {
        const Primitive& primitive = scene.primitives[static_cast<std::size_t>(index)];
        PrimitiveRange& range = buffers.ranges[static_cast<std::size_t>(index)];
        range = normalMap ? append(makeTangents(primitive, normalMap->uvSet, normalMap->transform), vertices, indices)
                          : append(primitive, vertices, indices);
    }
    using Usage = vk::BufferUsageFlagBits;
    buffers.vertices = gpu::makeBuffer(device, vertices.bytes, Usage::eVertexBuffer, "vertices");
    buffers.indices = gpu::makeBuffer(device, indices.bytes, Usage::eIndexBuffer, "indices");
    return buffers;
}

bool makesSameBuffers(const Scene& scene, const ShadingPlan& a, const ShadingPlan& b)
{
    return std::ranges::equal(tangentSources(scene, a), tangentSources(scene, b), [](const auto& x, const auto& y) {
        const TextureUse* first = x.second;
        const TextureUse* second = y.second;
        const bool same = first && second ? *first == *second : first == second;
        return x.first == y.first && same;
    });
}

} // namespace torrance
