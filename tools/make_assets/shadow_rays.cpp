#include "make_assets/shadow_rays.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>

namespace torrance::assets {
namespace {

// Rays start this far off the surface, in metres: wider than float's rounding at 5 m, thinner than anything in the
// scene.
constexpr float kStart = 1e-4f;

Mesh worldMesh(const DemoObject& object)
{
    Mesh mesh;
    for (const DemoPart& part : object.parts)
        appendSurface(mesh, part.surface, Chart{}, 1);
    for (vec3& position : mesh.positions)
        position = vec3(placed(object, dvec3(position)));
    return mesh;
}

void attach(RTCDevice device, RTCScene scene, const Mesh& mesh)
{
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                sizeof(vec3), mesh.positions.size()));
    std::copy(mesh.positions.begin(), mesh.positions.end(), vertices);
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.indices.size() / 3));
    std::copy(mesh.indices.begin(), mesh.indices.end(), indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

} // namespace

ShadowRays::ShadowRays(const DemoScene& demo)
{
    RTCDevice embree = rtcNewDevice("threads=1");
    RTCScene world = rtcNewScene(embree);
    for (const DemoObject& object : demo.objects)
        if (object.castsShadow)
            attach(embree, world, worldMesh(object));
    rtcCommitScene(world);
    device = embree;
    scene = world;
}

ShadowRays::~ShadowRays()
{
    rtcReleaseScene(static_cast<RTCScene>(scene));
    rtcReleaseDevice(static_cast<RTCDevice>(device));
}

bool ShadowRays::blocked(const dvec3& from, const dvec3& direction) const
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray{};
    ray.org_x = static_cast<float>(from.x);
    ray.org_y = static_cast<float>(from.y);
    ray.org_z = static_cast<float>(from.z);
    ray.dir_x = static_cast<float>(direction.x);
    ray.dir_y = static_cast<float>(direction.y);
    ray.dir_z = static_cast<float>(direction.z);
    ray.tnear = kStart;
    ray.tfar = std::numeric_limits<float>::infinity();
    ray.mask = ~0u;
    rtcOccluded1(static_cast<RTCScene>(scene), &context, &ray);
    return ray.tfar < 0.0f;
}

} // namespace torrance::assets
