#include "scene/tangents.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cfloat>
#include <cmath>
#include <numeric>
#include <tuple>

namespace torrance {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

/// A length or an area of the map below the least normal float is nothing: the standard computes in float, and so does
/// everybody who baked a map with it.
bool isSomething(double x)
{
    return x > FLT_MIN; // false for NaN too
}

/// What the corners are compared by: position, normal and coordinate in the map.
struct Vertex
{
    vec3 position;
    vec3 normal;
    vec2 uv;

    auto key() const { return std::tie(position.x, position.y, position.z, normal.x, normal.y, normal.z, uv.x, uv.y); }
};

struct Face
{
    std::array<std::uint32_t, 3> vertex;                         // welded
    std::array<std::uint32_t, 3> across = {kNone, kNone, kNone}; // the face behind the edge from corner k to k + 1
    std::array<std::uint32_t, 3> group = {kNone, kNone, kNone};
    dvec3 tangent = dvec3(0.0); // unit, along growing u
    bool upright = false;       // the map's (u, v) is not mirrored on the face
    bool mapped = false;        // has a tangent
    bool collapsed = false;     // two corners at one place
};

struct Mesh
{
    std::vector<Vertex> vertices; // one per vertex of the primitive
    std::vector<Face> faces;
    std::vector<vec4> groupTangents;
};

/// A vertex's coordinate that can be compared: not a number would break the order, so it becomes zero.
vec3 comparable(const vec3& v)
{
    return {std::isfinite(v.x) ? v.x : 0.0f, std::isfinite(v.y) ? v.y : 0.0f, std::isfinite(v.z) ? v.z : 0.0f};
}

std::vector<Vertex> gatherVertices(const Primitive& primitive, int uvSet, const glm::dmat3x2& uvTransform)
{
    const auto& uvs = primitive.uvs[static_cast<std::size_t>(uvSet)];
    std::vector<Vertex> vertices(primitive.positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const vec2 uv(uvTransform * dvec3(dvec2(uvs[i]), 1.0));
        vertices[i] = {comparable(primitive.positions[i]), comparable(primitive.normals[i]),
                       vec2(comparable(vec3(uv, 0.0f)))};
    }
    return vertices;
}

/// For each vertex the first one that is equal to it.
std::vector<std::uint32_t> weld(const std::vector<Vertex>& vertices)
{
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto ka = vertices[a].key(), kb = vertices[b].key();
        return ka < kb || (!(kb < ka) && a < b);
    });
    std::vector<std::uint32_t> welded(vertices.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool sameAsBefore = i > 0 && vertices[order[i]].key() == vertices[order[i - 1]].key();
        welded[order[i]] = sameAsBefore ? welded[order[i - 1]] : order[i];
    }
    return welded;
}

/// The direction of growing u on the face: the solution of the two edges' equations edge = du * T + dv * B for T.
void mapFace(Face& face, const std::vector<Vertex>& vertices)
{
    const Vertex &a = vertices[face.vertex[0]], &b = vertices[face.vertex[1]], &c = vertices[face.vertex[2]];
    face.collapsed = a.position == b.position || b.position == c.position || c.position == a.position;
    const dvec3 edge1 = dvec3(b.position) - dvec3(a.position), edge2 = dvec3(c.position) - dvec3(a.position);
    const dvec2 uv1 = dvec2(b.uv) - dvec2(a.uv), uv2 = dvec2(c.uv) - dvec2(a.uv);
    const double area = uv1.x * uv2.y - uv1.y * uv2.x;
    face.upright = area > 0.0;
    const dvec3 alongU = edge1 * uv2.y - edge2 * uv1.y;
    const dvec3 alongV = edge2 * uv1.x - edge1 * uv2.x;
    const double lengthU = glm::length(alongU), lengthV = glm::length(alongV);
    face.mapped = isSomething(std::abs(area)) && isSomething(lengthU) && isSomething(lengthV);
    if (face.mapped)
        face.tangent = alongU * ((face.upright ? 1.0 : -1.0) / lengthU);
}

/// Joins faces that run along an edge in opposite directions. Where more than two meet, the pairs are made in order of
/// faces.
void joinFaces(std::vector<Face>& faces)
{
    struct Edge
    {
        std::uint32_t low, high, face, corner;
        bool rising;
    };
    std::vector<Edge> edges;
    for (std::uint32_t f = 0; f < faces.size(); ++f)
        for (std::uint32_t k = 0; k < 3 && !faces[f].collapsed; ++k) {
            const std::uint32_t from = faces[f].vertex[k], to = faces[f].vertex[(k + 1) % 3];
            edges.push_back({std::min(from, to), std::max(from, to), f, k, from < to});
        }
    std::sort(edges.begin(), edges.end(), [](const Edge& x, const Edge& y) {
        return std::tie(x.low, x.high, x.face, x.corner) < std::tie(y.low, y.high, y.face, y.corner);
    });
    std::size_t begin = 0;
    while (begin < edges.size()) {
        // Rising and falling edges of one pair of vertices, each matched to the earliest free one of the other kind.
        std::vector<const Edge*> waiting;
        std::size_t end = begin;
        std::size_t firstWaiting = 0;
        for (; end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high; ++end)
        {
            const Edge& edge = edges[end];
            if (firstWaiting == waiting.size() || waiting[firstWaiting]->rising == edge.rising) {
                waiting.push_back(&edge);
                continue;
            }
            const Edge& other = *waiting[firstWaiting++];
            faces[edge.face].across[edge.corner] = other.face;
            faces[other.face].across[other.corner] = edge.face;
        }
        begin = end;
    }
}

std::size_t cornerOf(const Face& face, std::uint32_t vertex)
{
    return face.vertex[0] == vertex ? 0 : face.vertex[1] == vertex ? 1 : 2;
}

/// The faces around one corner that share a tangent: those that are reached across edges through the vertex and whose
/// map is mirrored like the first one's. A face without a map takes the side of the first group that reaches it.
std::vector<std::uint32_t> collectGroup(std::vector<Face>& faces, std::uint32_t first, std::size_t corner,
                                        std::uint32_t group)
{
    const std::uint32_t vertex = faces[first].vertex[corner];
    const bool upright = faces[first].upright;
    std::vector<std::uint32_t> members;
    std::vector<std::uint32_t> pending = {first};
    while (!pending.empty()) {
        const std::uint32_t f = pending.back();
        pending.pop_back();
        Face& face = faces[f];
        const std::size_t k = cornerOf(face, vertex);
        if (face.group[k] != kNone)
            continue;
        if (!face.mapped && face.group == std::array{kNone, kNone, kNone})
            face.upright = upright;
        if (face.upright != upright)
            continue;
        face.group[k] = group;
        members.push_back(f);
        for (const std::size_t edge : {(k + 2) % 3, k})
            if (face.across[edge] != kNone)
                pending.push_back(face.across[edge]);
    }
    return members;
}

dvec3 perpendicularTo(const dvec3& normal)
{
    const dvec3 axis = std::abs(normal.x) < 0.6 * glm::length(normal) ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    const dvec3 tangent = axis * glm::dot(normal, normal) - normal * glm::dot(normal, axis);
    return glm::length(tangent) > 0.0 ? glm::normalize(tangent) : dvec3(1, 0, 0);
}

/// v without its part along the (unit) normal, unit; zero where nothing is left.
dvec3 flattened(const dvec3& v, const dvec3& normal)
{
    const dvec3 inPlane = v - normal * glm::dot(normal, v);
    const double length = glm::length(inPlane);
    return isSomething(length) ? inPlane / length : dvec3(0.0);
}

/// Mean of the members' tangents in the plane of the normal, weighted by the angle of the corner in that plane.
vec4 groupTangent(const Mesh& mesh, const std::vector<std::uint32_t>& members, std::uint32_t vertex, bool upright)
{
    const dvec3 normal(mesh.vertices[vertex].normal);
    dvec3 sum(0.0);
    for (const std::uint32_t f : members) {
        const Face& face = mesh.faces[f];
        if (!face.mapped)
            continue;
        const std::size_t k = cornerOf(face, vertex);
        const dvec3 here(mesh.vertices[vertex].position);
        const dvec3 toNext = dvec3(mesh.vertices[face.vertex[(k + 1) % 3]].position) - here;
        const dvec3 toPrevious = dvec3(mesh.vertices[face.vertex[(k + 2) % 3]].position) - here;
        const double cosine = glm::dot(flattened(toNext, normal), flattened(toPrevious, normal));
        sum += std::acos(std::clamp(cosine, -1.0, 1.0)) * flattened(face.tangent, normal);
    }
    const dvec3 tangent = isSomething(glm::length(sum)) ? glm::normalize(sum) : perpendicularTo(normal);
    return vec4(vec3(tangent), upright ? -1.0f : 1.0f); // v runs down: an upright (u, v) has its bitangent against v
}

Mesh buildMesh(const Primitive& primitive, int uvSet, const glm::dmat3x2& uvTransform)
{
    Mesh mesh;
    mesh.vertices = gatherVertices(primitive, uvSet, uvTransform);
    const std::vector<std::uint32_t> welded = weld(mesh.vertices);
    mesh.faces.resize(primitive.indices.size() / 3);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        for (std::size_t k = 0; k < 3; ++k)
            mesh.faces[f].vertex[k] = welded[primitive.indices[3 * f + k]];
        mapFace(mesh.faces[f], mesh.vertices);
    }
    joinFaces(mesh.faces);
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            if (mesh.faces[f].collapsed || !mesh.faces[f].mapped || mesh.faces[f].group[k] != kNone)
                continue;
            const auto group = static_cast<std::uint32_t>(mesh.groupTangents.size());
            const std::vector<std::uint32_t> members = collectGroup(mesh.faces, f, k, group);
            mesh.groupTangents.push_back(groupTangent(mesh, members, mesh.faces[f].vertex[k], mesh.faces[f].upright));
        }
    return mesh;
}

/// Tangents of all corners, with what is missing borrowed from the first face that has one at the same vertex.
std::vector<vec4> cornerTangents(const Mesh& mesh)
{
    std::vector<std::uint32_t> lender(mesh.vertices.size(), kNone); // group
    for (const Face& face : mesh.faces)
        for (std::size_t k = 0; k < 3; ++k)
            if (face.group[k] != kNone && lender[face.vertex[k]] == kNone)
                lender[face.vertex[k]] = face.group[k];
    std::vector<vec4> tangents;
    tangents.reserve(3 * mesh.faces.size());
    for (const Face& face : mesh.faces)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t group = face.group[k] != kNone ? face.group[k] : lender[face.vertex[k]];
            const dvec3 normal(mesh.vertices[face.vertex[k]].normal);
            tangents.push_back(group != kNone ? mesh.groupTangents[group] : vec4(vec3(perpendicularTo(normal)), 1.0f));
        }
    return tangents;
}

template <typename Attribute>
void appendVertex(std::vector<Attribute>& to, const std::vector<Attribute>& from, std::uint32_t index)
{
    if (!from.empty())
        to.push_back(from[index]);
}

/// One vertex per pair of an old vertex and a tangent, in order of first use.
Primitive splitVertices(const Primitive& primitive, const std::vector<vec4>& tangents)
{
    Primitive out;
    out.name = primitive.name;
    out.topology = primitive.topology;
    out.material = primitive.material;
    out.boundsMin = primitive.boundsMin;
    out.boundsMax = primitive.boundsMax;
    out.indices.reserve(primitive.indices.size());
    std::vector<std::vector<std::uint32_t>> copies(primitive.positions.size()); // new vertices of each old one
    for (std::size_t c = 0; c < tangents.size(); ++c) {
        const std::uint32_t old = primitive.indices[c];
        const auto found = std::find_if(copies[old].begin(), copies[old].end(),
                                        [&](std::uint32_t i) { return out.tangents[i] == tangents[c]; });
        if (found != copies[old].end()) {
            out.indices.push_back(*found);
            continue;
        }
        const auto index = static_cast<std::uint32_t>(out.positions.size());
        copies[old].push_back(index);
        out.indices.push_back(index);
        appendVertex(out.positions, primitive.positions, old);
        appendVertex(out.normals, primitive.normals, old);
        appendVertex(out.uvs[0], primitive.uvs[0], old);
        appendVertex(out.uvs[1], primitive.uvs[1], old);
        appendVertex(out.colors, primitive.colors, old);
        out.tangents.push_back(tangents[c]);
    }
    return out;
}

} // namespace

Primitive makeTangents(const Primitive& primitive, int uvSet, const glm::dmat3x2& uvTransform)
{
    assert(primitive.topology == Topology::triangles && primitive.indices.size() % 3 == 0);
    assert(primitive.normals.size() == primitive.positions.size());
    assert(primitive.uvs[static_cast<std::size_t>(uvSet)].size() == primitive.positions.size());
    return splitVertices(primitive, cornerTangents(buildMesh(primitive, uvSet, uvTransform)));
}

} // namespace torrance
