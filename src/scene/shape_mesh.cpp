#include "scene/shape_mesh.h"

#include "scene/primitive_bounds.h"

#include <cmath>

namespace torrance {
namespace {

void addVertex(Primitive& mesh, const dvec3& position, const dvec3& normal, const dvec3& tangent, const dvec2& uv)
{
    mesh.positions.emplace_back(position);
    mesh.normals.emplace_back(normal);
    mesh.tangents.emplace_back(vec3(tangent), 1.0f); // v runs down, so that the bitangent points up
    mesh.uvs[0].emplace_back(uv);
}

/// Corners in the order upper left, lower left, upper right, lower right.
void addQuad(Primitive& mesh, std::uint32_t upperLeft, std::uint32_t lowerLeft, std::uint32_t upperRight,
             std::uint32_t lowerRight)
{
    mesh.indices.insert(mesh.indices.end(), {upperLeft, lowerLeft, lowerRight, upperLeft, lowerRight, upperRight});
}

/// The square of half side 1 whose middle is at `normal`, its u along `right`.
void addFace(Primitive& mesh, const dvec3& middle, const dvec3& normal, const dvec3& right)
{
    const dvec3 up = glm::cross(normal, right);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    addVertex(mesh, middle - right + up, normal, right, {0.0, 0.0});
    addVertex(mesh, middle - right - up, normal, right, {0.0, 1.0});
    addVertex(mesh, middle + right + up, normal, right, {1.0, 0.0});
    addVertex(mesh, middle + right - up, normal, right, {1.0, 1.0});
    addQuad(mesh, first, first + 1, first + 2, first + 3);
}

} // namespace

Primitive sphereMesh()
{
    Primitive mesh;
    mesh.name = "sphere";
    for (int ring = 0; ring <= kSphereRings; ++ring)
        for (int segment = 0; segment <= kSphereSegments; ++segment) {
            const double u = static_cast<double>(segment) / kSphereSegments;
            const double v = static_cast<double>(ring) / kSphereRings;
            const double around = 2.0 * kPi * (u - 0.5), down = kPi * v;
            // The poles exactly, whatever sin(pi) is in floating point.
            const double radius = ring == 0 || ring == kSphereRings ? 0.0 : std::sin(down);
            const dvec3 normal(radius * std::sin(around), std::cos(down), radius * std::cos(around));
            addVertex(mesh, normal, normal, {std::cos(around), 0.0, -std::sin(around)}, {u, v});
        }
    constexpr std::uint32_t kRow = kSphereSegments + 1;
    for (std::uint32_t ring = 0; ring < kSphereRings; ++ring)
        for (std::uint32_t segment = 0; segment < kSphereSegments; ++segment) {
            const std::uint32_t first = ring * kRow + segment;
            if (ring == 0) // at a pole one triangle of the two has no area
                mesh.indices.insert(mesh.indices.end(), {first, first + kRow, first + kRow + 1});
            else if (ring == kSphereRings - 1)
                mesh.indices.insert(mesh.indices.end(), {first, first + kRow, first + 1});
            else
                addQuad(mesh, first, first + kRow, first + 1, first + kRow + 1);
        }
    setBounds(mesh);
    return mesh;
}

Primitive planeMesh()
{
    Primitive mesh;
    mesh.name = "plane";
    addFace(mesh, dvec3(0.0), {0, 0, 1}, {1, 0, 0});
    setBounds(mesh);
    return mesh;
}

Primitive cubeMesh()
{
    Primitive mesh;
    mesh.name = "cube";
    const dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    for (const dvec3& side : {z, x, -z, -x})
        addFace(mesh, side, side, glm::cross(y, side));
    addFace(mesh, y, y, x);
    addFace(mesh, -y, -y, x);
    setBounds(mesh);
    return mesh;
}

} // namespace torrance
