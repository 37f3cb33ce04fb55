#include "files/obj_primitives.h"

#include "files/gltf_normals.h"
#include "files/polygon.h"
#include "image/srgb.h"
#include "scene/primitive_bounds.h"

#include <cmath>
#include <map>
#include <unordered_map>

namespace torrance {
namespace {

/// What makes a vertex: corners that agree in all three share one.
struct VertexKey
{
    int position;
    int uv;
    std::int64_t normal; // the file's, or one that NormalSource numbers

    bool operator==(const VertexKey&) const = default;
};

struct VertexHash
{
    std::size_t operator()(const VertexKey& key) const
    {
        // Multipliers of SplitMix64 (Steele, Lea & Flood 2014), so that neighbours do not share a bucket.
        std::uint64_t hash = static_cast<std::uint64_t>(key.position) * 0x9e3779b97f4a7c15u;
        hash = (hash ^ (hash >> 29) ^ static_cast<std::uint64_t>(key.uv)) * 0xbf58476d1ce4e5b9u;
        hash = (hash ^ (hash >> 32) ^ static_cast<std::uint64_t>(key.normal)) * 0x94d049bb133111ebu;
        return static_cast<std::size_t>(hash ^ (hash >> 31));
    }
};

struct Face
{
    std::size_t number = 0;
    std::size_t firstCorner = 0;
    std::uint32_t corners = 0;
    std::uint32_t smoothing = 0;
};

/// In double: the squares of a model's edges need not lie in the range of floats.
vec3 unitOrZero(const dvec3& v)
{
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? vec3(v / length) : vec3(0.0f);
}

class PrimitiveBuilder
{
public:
    PrimitiveBuilder(const ObjText& from, const ObjGeometry& vertices, const SceneLimits& most, LoadReport& messages)
        : text(from), geometry(vertices), limits(most), report(messages)
    {
    }

    std::vector<ObjPrimitive> build()
    {
        groupFaces();
        for (const auto& [shape, material] : order)
            addPrimitive(shape, material, faces.at({shape, material}));
        if (missingUvs > 0)
            report.warn("", "has " + std::to_string(missingUvs) +
                                " corners without texture coordinates among others that have them: 0 is used");
        return std::move(result);
    }

private:
    void groupFaces()
    {
        std::size_t run = 0, corner = 0;
        for (std::size_t face = 0; face < text.corners.size(); ++face) {
            if (run + 1 < text.runs.size() && text.runs[run + 1].firstFace == face)
                ++run;
            const ObjRun& belongs = text.runs[run];
            const auto [group, isNew] = faces.try_emplace({belongs.shape, belongs.material});
            if (isNew)
                order.push_back(group->first);
            group->second.push_back({face, corner, text.corners[face], belongs.smoothing});
            addToMeans(group->second.back());
            corner += text.corners[face];
        }
    }

    std::vector<dvec3> outline(const Face& face) const
    {
        std::vector<dvec3> corners;
        for (std::uint32_t i = 0; i < face.corners; ++i)
            corners.emplace_back(geometry.positions[index(geometry.corners[face.firstCorner + i].position)]);
        return corners;
    }

    static std::size_t index(int number) { return static_cast<std::size_t>(number); }

    static std::uint64_t meanKey(int position, std::uint32_t smoothing)
    {
        return static_cast<std::uint64_t>(smoothing) << 32 | static_cast<std::uint32_t>(position);
    }

    /// Of all shapes and materials: a smoothing group does not end at either.
    void addToMeans(const Face& face)
    {
        if (face.smoothing == 0)
            return;
        bool lacks = false;
        for (std::uint32_t i = 0; i < face.corners; ++i)
            lacks = lacks || geometry.corners[face.firstCorner + i].normal < 0;
        if (!lacks)
            return;
        const dvec3 vector = newellVector(outline(face));
        for (std::uint32_t i = 0; i < face.corners; ++i)
            means[meanKey(geometry.corners[face.firstCorner + i].position, face.smoothing)] += vector;
    }

    void addPrimitive(int shape, int material, const std::vector<Face>& own)
    {
        ObjPrimitive added;
        added.shape = shape;
        added.primitive.material = material;
        added.primitive.name = text.shapes[index(shape)];
        if (material >= 0)
            added.primitive.name += (added.primitive.name.empty() ? "" : " ") + text.materials[index(material)];
        textured = false;
        for (const Face& face : own)
            for (std::uint32_t i = 0; i < face.corners; ++i)
                textured = textured || geometry.corners[face.firstCorner + i].uv >= 0;
        known.clear();
        for (const Face& face : own)
            addFace(added.primitive, face);
        if (const std::size_t repaired = normalizeNormals(added.primitive); repaired > 0)
            report.warn(added.primitive.name,
                        "has " + std::to_string(repaired) + " normals of no direction, computed from its triangles");
        setBounds(added.primitive);
        result.push_back(std::move(added));
    }

    void addFace(Primitive& primitive, const Face& face)
    {
        const std::vector<dvec3> corners = outline(face);
        const vec3 flat = unitOrZero(newellVector(corners));
        std::vector<std::uint32_t> vertices;
        for (std::uint32_t i = 0; i < face.corners; ++i)
            vertices.push_back(vertexOf(primitive, geometry.corners[face.firstCorner + i], face, flat));
        std::vector<std::uint32_t> triangles;
        if (!triangulate(corners, triangles, budget))
            report.fail("face " + std::to_string(face.number + 1), "has an outline too intricate to be cut",
                        "triangulate the model before it is exported");
        for (const std::uint32_t corner : triangles)
            primitive.indices.push_back(vertices[corner]);
    }

    std::uint32_t vertexOf(Primitive& primitive, const ObjCorner& corner, const Face& face, const vec3& flat)
    {
        // Behind the file's normals come the smoothing groups, behind those the faces.
        constexpr std::int64_t kSmooth = std::int64_t(1) << 32, kFlat = std::int64_t(1) << 33;
        const std::int64_t normal = corner.normal >= 0   ? corner.normal
                                    : face.smoothing > 0 ? kSmooth + face.smoothing
                                                         : kFlat + static_cast<std::int64_t>(face.number);
        const auto [vertex, isNew] = known.try_emplace({corner.position, corner.uv, normal},
                                                       static_cast<std::uint32_t>(primitive.positions.size()));
        if (!isNew)
            return vertex->second;
        if (++vertexCount > limits.vertices)
            report.fail(primitive.name, "brings the file to more than " + std::to_string(limits.vertices) + " vertices",
                        "split the model");
        primitive.positions.push_back(geometry.positions[index(corner.position)]);
        primitive.normals.push_back(corner.normal >= 0 ? geometry.normals[index(corner.normal)]
                                    : face.smoothing > 0
                                        ? unitOrZero(means.at(meanKey(corner.position, face.smoothing)))
                                        : flat);
        if (textured)
            primitive.uvs[0].push_back(uvOf(corner));
        if (!geometry.colors.empty())
            primitive.colors.push_back(colorOf(geometry.colors[index(corner.position)]));
        return vertex->second;
    }

    vec2 uvOf(const ObjCorner& corner)
    {
        missingUvs += corner.uv < 0 ? 1 : 0;
        const vec2 uv = corner.uv < 0 ? vec2(0.0f) : geometry.uvs[index(corner.uv)];
        return {uv.x, 1.0f - uv.y};
    }

    static vec4 colorOf(const vec3& stored)
    {
        return vec4(vec3(srgbDecode(stored.r), srgbDecode(stored.g), srgbDecode(stored.b)), 1.0f);
    }

    const ObjText& text;
    const ObjGeometry& geometry;
    const SceneLimits& limits;
    LoadReport& report;
    std::vector<std::pair<int, int>> order; // shape and material
    std::map<std::pair<int, int>, std::vector<Face>> faces;
    std::unordered_map<std::uint64_t, dvec3> means;
    std::unordered_map<VertexKey, std::uint32_t, VertexHash> known; // of the primitive that is built
    bool textured = false;                                          // that primitive
    CuttingBudget budget;
    std::size_t vertexCount = 0;
    std::size_t missingUvs = 0;
    std::vector<ObjPrimitive> result;
};

} // namespace

std::vector<ObjPrimitive> buildPrimitives(const ObjText& text, const ObjGeometry& geometry, const SceneLimits& limits,
                                          LoadReport& report)
{
    return PrimitiveBuilder(text, geometry, limits, report).build();
}

} // namespace torrance
