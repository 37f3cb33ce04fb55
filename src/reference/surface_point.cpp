#include "reference/surface_point.h"

#include "reference/analytic_shape.h"

#include <cmath>

namespace torrance {
namespace {

/// det(M) * inverse(transpose(M)) without the division: right for singular matrices too.
dmat3 cofactors(const dmat3& m)
{
    return dmat3(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
}

dvec3 unitOr(const dvec3& v, const dvec3& fallback)
{
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : fallback;
}

/// The weighted sum of what `at` gives for each of the three corners.
template <typename Wide, typename At>
Wide interpolate(const std::array<std::uint32_t, 3>& corners, const dvec3& weights, const At& at)
{
    return weights[0] * Wide(at(corners[0])) + weights[1] * Wide(at(corners[1])) + weights[2] * Wide(at(corners[2]));
}

struct Corners
{
    const Primitive& primitive;
    dmat3 worldFromObject;
    double handedness; // sign of its determinant
    std::array<std::uint32_t, 3> vertices;
    dvec3 weights;
};

Corners cornersOf(const RayCaster& caster, const Hit& hit)
{
    const Primitive& primitive = caster.meshOf(hit.instance);
    const dmat3 matrix(caster.scene().instances[static_cast<std::size_t>(hit.instance)].worldFromObject);
    const std::size_t first = 3 * static_cast<std::size_t>(hit.triangle);
    return {primitive,
            matrix,
            glm::determinant(matrix) < 0.0 ? -1.0 : 1.0,
            {primitive.indices[first], primitive.indices[first + 1], primitive.indices[first + 2]},
            hit.barycentric};
}

void fillNormals(const Corners& c, SurfacePoint& point)
{
    const Primitive& p = c.primitive;
    if (p.normals.empty())
        return;
    const dvec3 normal = interpolate<dvec3>(c.vertices, c.weights, [&](std::uint32_t v) { return p.normals[v]; });
    point.normal = unitOr(c.handedness * (cofactors(c.worldFromObject) * normal), point.normal);
    if (p.tangents.empty())
        return;
    const dvec4 tangent = interpolate<dvec4>(c.vertices, c.weights, [&](std::uint32_t v) { return p.tangents[v]; });
    const dvec3 unit = unitOr(c.worldFromObject * dvec3(tangent), dvec3(0.0));
    if (unit != dvec3(0.0))
        point.frame = TangentFrame{unit, c.handedness * tangent.w * glm::cross(point.normal, unit)};
}

void fillAttributes(const Corners& c, SurfacePoint& point)
{
    const Primitive& p = c.primitive;
    fillNormals(c, point);
    for (std::size_t set = 0; set < 2; ++set)
        if (!p.uvs[set].empty())
            point.uvs[set] = interpolate<dvec2>(c.vertices, c.weights, [&](std::uint32_t v) { return p.uvs[set][v]; });
    if (!p.colors.empty())
        point.color = interpolate<dvec4>(c.vertices, c.weights, [&](std::uint32_t v) { return p.colors[v]; });
}

/// The plane's texture coordinates where one ray meets it, less those where another does.
dvec2 uvStep(const Corners& c, const std::array<dvec3, 3>& places, const Ray& from, const Ray& to, std::size_t set)
{
    const std::optional<Hit> first = meetTriangle(places, from), second = meetTriangle(places, to);
    if (!first || !second)
        return dvec2(0.0);
    const std::vector<vec2>& uvs = c.primitive.uvs[set];
    return interpolate<dvec2>(c.vertices, second->barycentric - first->barycentric,
                              [&](std::uint32_t v) { return uvs[v]; });
}

SurfaceFootprint footprintOf(const Corners& c, const std::array<dvec3, 3>& places, const QuadRays& quad)
{
    SurfaceFootprint footprint = {.uvs = {}, .levelBias = quad.levelBias};
    for (std::size_t set = 0; set < 2; ++set)
        if (!c.primitive.uvs[set].empty())
            footprint.uvs[set] = {uvStep(c, places, quad.first, quad.right, set),
                                  uvStep(c, places, quad.first, quad.below, set)};
    return footprint;
}

SurfacePoint shapePoint(const RayCaster& caster, const Ray& ray, const Hit& hit)
{
    const AnalyticShape& shape = caster.scene().shapes[static_cast<std::size_t>(hit.shape)];
    const std::optional<ShapeHit> met = intersectShape(shape, caster.origin(), ray, Sides::both);
    SurfacePoint point;
    point.position = met->position;
    point.normal = met->normal;
    point.geometricNormal = hit.front ? met->normal : -met->normal;
    point.object = -1 - hit.shape;
    return point;
}

SurfacePoint trianglePoint(const RayCaster& caster, const Hit& hit, const QuadRays* quad)
{
    const Corners c = cornersOf(caster, hit);
    const std::array<dvec3, 3> places = triangleCorners(caster.scene(), hit.instance, hit.triangle, caster.origin());
    SurfacePoint point;
    point.position = c.weights[0] * places[0] + c.weights[1] * places[1] + c.weights[2] * places[2];
    const dvec3 front = unitOr(c.handedness * glm::cross(places[1] - places[0], places[2] - places[0]), dvec3(0, 0, 1));
    point.normal = front;
    point.geometricNormal = hit.front ? front : -front;
    point.object = caster.scene().instances[static_cast<std::size_t>(hit.instance)].object;
    fillAttributes(c, point);
    if (quad)
        point.footprint = footprintOf(c, places, *quad);
    return point;
}

} // namespace

SurfacePoint makeSurfacePoint(const RayCaster& caster, const Ray& ray, const Hit& hit, const QuadRays* quad)
{
    SurfacePoint point = hit.shape >= 0 ? shapePoint(caster, ray, hit) : trianglePoint(caster, hit, quad);
    point.view = -ray.direction;
    point.distance = hit.distance;
    point.front = hit.front;
    point.material = materialIndexOf(caster.scene(), hit);
    return point;
}

} // namespace torrance
