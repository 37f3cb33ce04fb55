#include "files/gltf_normals.h"

#include <cmath>

namespace torrance {
namespace {

/// Squares of lengths below this are subnormal floats' own: no direction can be read from such a vector.
constexpr double kNoLength = 1e-37;

dvec3 unitOr(const dvec3& v, const dvec3& otherwise)
{
    const double length = glm::length(v);
    return length > kNoLength && std::isfinite(length) ? v / length : otherwise;
}

const dvec3 kUp(0.0, 0.0, 1.0);

/// Twice the area, along the normal.
dvec3 faceVector(const Primitive& primitive, std::size_t corner)
{
    const auto at = [&](std::size_t k) { return dvec3(primitive.positions[primitive.indices[corner + k]]); };
    return glm::cross(at(1) - at(0), at(2) - at(0));
}

template <typename T>
void unshare(std::vector<T>& attribute, const std::vector<std::uint32_t>& indices)
{
    if (attribute.empty())
        return;
    std::vector<T> unshared(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i)
        unshared[i] = attribute[indices[i]];
    attribute = std::move(unshared);
}

std::vector<dvec3> meanFaceVectors(const Primitive& primitive)
{
    std::vector<dvec3> sums(primitive.positions.size(), dvec3(0.0));
    if (primitive.topology == Topology::triangles)
        for (std::size_t corner = 0; corner + 2 < primitive.indices.size(); corner += 3) {
            const dvec3 face = faceVector(primitive, corner);
            for (std::size_t k = 0; k < 3; ++k)
                sums[primitive.indices[corner + k]] += face;
        }
    return sums;
}

} // namespace

void makeFlat(Primitive& primitive)
{
    primitive.tangents.clear();
    std::vector<vec3> normals(primitive.indices.size());
    for (std::size_t corner = 0; corner + 2 < primitive.indices.size(); corner += 3)
        normals[corner] = normals[corner + 1] = normals[corner + 2] = vec3(unitOr(faceVector(primitive, corner), kUp));
    unshare(primitive.positions, primitive.indices);
    unshare(primitive.colors, primitive.indices);
    for (std::vector<vec2>& uvs : primitive.uvs)
        unshare(uvs, primitive.indices);
    primitive.normals = std::move(normals);
    for (std::size_t i = 0; i < primitive.indices.size(); ++i)
        primitive.indices[i] = static_cast<std::uint32_t>(i);
}

std::size_t normalizeNormals(Primitive& primitive)
{
    std::vector<std::size_t> without;
    for (std::size_t i = 0; i < primitive.normals.size(); ++i) {
        const dvec3 normal = unitOr(dvec3(primitive.normals[i]), dvec3(0.0));
        primitive.normals[i] = vec3(normal);
        if (normal == dvec3(0.0))
            without.push_back(i);
    }
    if (without.empty())
        return 0;
    const std::vector<dvec3> means = meanFaceVectors(primitive);
    for (const std::size_t i : without)
        primitive.normals[i] = vec3(unitOr(means[i], kUp));
    return without.size();
}

bool normalizeTangents(Primitive& primitive)
{
    for (vec4& tangent : primitive.tangents) {
        const dvec3 direction = unitOr(dvec3(tangent), dvec3(0.0));
        if (direction == dvec3(0.0))
            return false;
        tangent = vec4(vec3(direction), tangent.w < 0.0f ? -1.0f : 1.0f);
    }
    return true;
}

} // namespace torrance
