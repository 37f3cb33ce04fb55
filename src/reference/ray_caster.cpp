#include "reference/ray_caster.h"

#include "reference/analytic_shape.h"
#include "scene/tangents.h"

#include <algorithm>
#include <cmath>
#include <embree3/rtcore.h>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

namespace torrance {
namespace {

struct ReleaseDevice
{
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene
{
    void operator()(RTCScene rays) const { rtcReleaseScene(rays); }
};
struct ReleaseGeometry
{
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using GeometryPointer = std::unique_ptr<RTCGeometryTy, ReleaseGeometry>;
using DevicePointer = std::unique_ptr<RTCDeviceTy, ReleaseDevice>;
using ScenePointer = std::unique_ptr<RTCSceneTy, ReleaseScene>;

/// What Embree's filter needs to judge a hit; the context comes first because Embree hands back a pointer to it.
struct Query
{
    RTCIntersectContext context;
    const RayCaster* caster;
    const Ray* ray;
    double beyond;
    double farthest; // hits there and farther do not count
    Faces faces;
    const RayCaster::Accept* accept;
};

std::optional<Hit> judgedHit(const Query& query, int instance, int triangle)
{
    const Scene& scene = query.caster->scene();
    std::optional<Hit> hit =
        meetTriangle(triangleCorners(scene, instance, triangle, query.caster->origin()), *query.ray);
    if (!hit || !(hit->distance > query.beyond) || !(hit->distance < query.farthest))
        return std::nullopt;
    hit->instance = instance;
    hit->triangle = triangle;
    if (glm::determinant(dmat3(scene.instances[static_cast<std::size_t>(instance)].worldFromObject)) < 0.0)
        hit->front = !hit->front;
    if (!hit->front && query.faces == Faces::drawn && !materialOf(scene, materialIndexOf(scene, *hit)).doubleSided)
        return std::nullopt;
    if (*query.accept && !(*query.accept)(*hit))
        return std::nullopt;
    return hit;
}

void filterHit(const RTCFilterFunctionNArguments* arguments)
{
    const Query& query = *reinterpret_cast<const Query*>(arguments->context);
    for (unsigned int i = 0; i < arguments->N; ++i)
        if (arguments->valid[i] != 0 &&
            !judgedHit(query, static_cast<int>(RTCHitN_geomID(arguments->hit, arguments->N, i)),
                       static_cast<int>(RTCHitN_primID(arguments->hit, arguments->N, i))))
            arguments->valid[i] = 0;
}

template <typename T>
T* newBuffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t stride, std::size_t count)
{
    void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, stride, count);
    if (buffer == nullptr)
        throw std::runtime_error("Embree has no memory for " + std::to_string(count) + " elements");
    return static_cast<T*>(buffer);
}

void attachInstance(RTCDevice device, RTCScene rays, const Scene& scene, std::size_t index, const dvec3& origin)
{
    const Instance& instance = scene.instances[index];
    const Primitive& primitive = scene.primitives[static_cast<std::size_t>(instance.primitive)];
    if (primitive.topology != Topology::triangles || primitive.indices.size() < 3)
        return;
    const GeometryPointer geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    auto* const vertices = newBuffer<float>(geometry.get(), RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3,
                                            3 * sizeof(float), primitive.positions.size());
    for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
        const dvec3 p = dvec3(instance.worldFromObject * dvec4(dvec3(primitive.positions[i]), 1.0)) - origin;
        for (std::size_t c = 0; c < 3; ++c)
            vertices[3 * i + c] = static_cast<float>(p[static_cast<int>(c)]);
    }
    auto* const indices = newBuffer<std::uint32_t>(geometry.get(), RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3,
                                                   3 * sizeof(std::uint32_t), primitive.indices.size() / 3);
    std::copy_n(primitive.indices.begin(), primitive.indices.size() / 3 * 3, indices);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(rays, geometry.get(), static_cast<unsigned int>(index));
}

/// The meshes that a normal map bends and that bring no tangents, with tangents; by Scene::primitives.
std::map<int, Primitive> tangentMeshes(const Scene& scene)
{
    std::map<int, Primitive> meshes;
    for (const Instance& instance : scene.instances) {
        const Primitive& mesh = scene.primitives[static_cast<std::size_t>(instance.primitive)];
        const TextureUse& map = materialOf(scene, mesh.material).normal;
        if (map.used() && mesh.topology == Topology::triangles && mesh.tangents.empty() && !mesh.normals.empty() &&
            !mesh.uvs[static_cast<std::size_t>(map.uvSet)].empty() && !meshes.contains(instance.primitive))
            meshes.emplace(instance.primitive, makeTangents(mesh, map.uvSet, map.transform));
    }
    return meshes;
}

std::optional<Hit> closestShape(const Query& query)
{
    const auto& [context, caster, ray, beyond, farthest, faces, accept] = query;
    std::optional<Hit> best;
    const std::vector<AnalyticShape>& shapes = caster->scene().shapes;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const bool bothSides = faces == Faces::both || materialOf(caster->scene(), shapes[i].material).doubleSided;
        const std::optional<ShapeHit> met =
            intersectShape(shapes[i], caster->origin(), *ray, bothSides ? Sides::both : Sides::front);
        if (!met || !(met->distance > beyond) || !(met->distance < farthest) ||
            (best && met->distance >= best->distance))
            continue;
        Hit hit;
        hit.shape = static_cast<int>(i);
        hit.distance = met->distance;
        hit.front = glm::dot(met->normal, ray->direction) < 0.0;
        if (!*accept || (*accept)(hit))
            best = hit;
    }
    return best;
}

/// Embree's ray begins before the ray and ends beyond `farthest`; what it meets there is judged in double.
RTCRay floatRay(const Ray& ray, double farthest)
{
    const double lead =
        kFloatSlack * std::max({std::abs(ray.origin.x), std::abs(ray.origin.y), std::abs(ray.origin.z)});
    const dvec3 start = ray.origin - lead * ray.direction;
    RTCRay floats{};
    floats.org_x = static_cast<float>(start.x);
    floats.org_y = static_cast<float>(start.y);
    floats.org_z = static_cast<float>(start.z);
    floats.dir_x = static_cast<float>(ray.direction.x);
    floats.dir_y = static_cast<float>(ray.direction.y);
    floats.dir_z = static_cast<float>(ray.direction.z);
    floats.tfar = static_cast<float>(farthest * (1.0 + kFloatSlack) + 2.0 * lead);
    floats.mask = ~0u;
    return floats;
}

Query queryOf(const RayCaster& caster, const Ray& ray, double beyond, double farthest, Faces faces,
              const RayCaster::Accept& accept)
{
    Query query{{}, &caster, &ray, beyond, farthest, faces, &accept};
    rtcInitIntersectContext(&query.context);
    query.context.filter = filterHit;
    return query;
}

} // namespace

std::optional<Hit> meetTriangle(const std::array<dvec3, 3>& corners, const Ray& ray)
{
    const dvec3 e1 = corners[1] - corners[0];
    const dvec3 e2 = corners[2] - corners[0];
    const dvec3 p = glm::cross(ray.direction, e2);
    const double determinant = glm::dot(e1, p);
    if (determinant == 0.0 || !std::isfinite(determinant))
        return std::nullopt;
    const dvec3 s = ray.origin - corners[0];
    const dvec3 q = glm::cross(s, e1);
    const double u = glm::dot(s, p) / determinant;
    const double v = glm::dot(ray.direction, q) / determinant;
    Hit hit;
    hit.barycentric = dvec3(1.0 - u - v, u, v);
    hit.distance = glm::dot(e2, q) / determinant;
    hit.front = determinant > 0.0;
    return hit;
}

struct RayCaster::State
{
    const Scene* scene;
    dvec3 origin;
    std::map<int, Primitive> tangentMeshes;
    DevicePointer device;
    ScenePointer rays;
};

RayCaster::RayCaster(const Scene& scene, const dvec3& origin) : state(std::make_unique<State>())
{
    state->scene = &scene;
    state->origin = origin;
    state->tangentMeshes = tangentMeshes(scene);
    state->device.reset(rtcNewDevice("threads=1"));
    if (!state->device)
        throw std::runtime_error("Embree gives no device");
    state->rays.reset(rtcNewScene(state->device.get()));
    rtcSetSceneFlags(state->rays.get(),
                     static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    for (std::size_t i = 0; i < scene.instances.size(); ++i)
        attachInstance(state->device.get(), state->rays.get(), scene, i, origin);
    rtcCommitScene(state->rays.get());
    if (rtcGetDeviceError(state->device.get()) != RTC_ERROR_NONE)
        throw std::runtime_error("Embree cannot build the scene " + scene.name);
}

RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

const Scene& RayCaster::scene() const
{
    return *state->scene;
}

const dvec3& RayCaster::origin() const
{
    return state->origin;
}

const Primitive& RayCaster::meshOf(int instance) const
{
    const int primitive = state->scene->instances[static_cast<std::size_t>(instance)].primitive;
    const auto made = state->tangentMeshes.find(primitive);
    return made != state->tangentMeshes.end() ? made->second
                                              : state->scene->primitives[static_cast<std::size_t>(primitive)];
}

std::optional<Hit> RayCaster::closest(const Ray& ray, double beyond, const Accept& accept, Faces faces) const
{
    constexpr double kNowhere = std::numeric_limits<double>::infinity();
    Query query = queryOf(*this, ray, beyond, kNowhere, faces, accept);
    const std::optional<Hit> best = closestShape(query);
    RTCRayHit hit{};
    hit.ray = floatRay(ray, kNowhere);
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(state->rays.get(), &query.context, &hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return best;
    const std::optional<Hit> met = judgedHit(query, static_cast<int>(hit.hit.geomID), static_cast<int>(hit.hit.primID));
    return met && (!best || met->distance < best->distance) ? met : best;
}

bool RayCaster::blocked(const Ray& ray, double farthest, const Accept& accept) const
{
    Query query = queryOf(*this, ray, 0.0, farthest, Faces::both, accept);
    if (closestShape(query))
        return true;
    RTCRay floats = floatRay(ray, farthest);
    rtcOccluded1(state->rays.get(), &query.context, &floats);
    return floats.tfar < 0.0f;
}

std::array<dvec3, 3> triangleCorners(const Scene& scene, int instance, int triangle, const dvec3& origin)
{
    const Instance& placed = scene.instances[static_cast<std::size_t>(instance)];
    const Primitive& primitive = scene.primitives[static_cast<std::size_t>(placed.primitive)];
    std::array<dvec3, 3> corners;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t vertex = primitive.indices[3 * static_cast<std::size_t>(triangle) + c];
        corners[c] = dvec3(placed.worldFromObject * dvec4(dvec3(primitive.positions[vertex]), 1.0)) - origin;
    }
    return corners;
}

const Material& materialOf(const Scene& scene, int material)
{
    static const Material kDefault;
    return material < 0 ? kDefault : scene.materials[static_cast<std::size_t>(material)];
}

int materialIndexOf(const Scene& scene, const Hit& hit)
{
    if (hit.shape >= 0)
        return scene.shapes[static_cast<std::size_t>(hit.shape)].material;
    const Instance& instance = scene.instances[static_cast<std::size_t>(hit.instance)];
    return scene.primitives[static_cast<std::size_t>(instance.primitive)].material;
}

} // namespace torrance
