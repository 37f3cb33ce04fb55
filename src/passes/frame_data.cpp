#include "passes/frame_data.h"

#include "brdf/texture_filter.h"
#include "plan/attribute_plan.h"
#include "plan/level_plan.h"
#include "plan/light_plan.h"
#include "scene/camera_view.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace torrance {
namespace {

// The point of a pixel's ray that is linear in the pixel: one metre along the axis of view, or the ray's start.
dvec3 linearRayPoint(const Camera& camera, const dvec3& forward, int width, int height, double x, double y)
{
    const Ray ray = primaryRay(camera, width, height, x, y);
    return camera.kind == Camera::Kind::orthographic ? ray.origin : ray.direction / glm::dot(ray.direction, forward);
}

// Rotation about +Y that takes the panorama's directions to the world's.
dmat3 worldFromEnvironment(double rotation)
{
    const double c = std::cos(rotation), s = std::sin(rotation);
    return dmat3(dvec3(c, 0.0, -s), dvec3(0.0, 1.0, 0.0), dvec3(s, 0.0, c));
}

// The mip of the panorama whose texels at the horizon are as large as the picture's middle pixel.
float panoramaLevel(const shared::Frame& frame, int panoramaWidth)
{
    if (panoramaWidth == 0 || frame.orthographic != 0.0f)
        return 0.0f;
    const double texelAngle = 2.0 * kPi / panoramaWidth;
    return static_cast<float>(std::max(0.0, std::log2(double(glm::length(frame.across)) / texelAngle)));
}

shared::Instance makeInstance(const dmat4& eyeFromObject, int material, int object)
{
    const dmat3 linear = dmat3(eyeFromObject);
    const double sign = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
    // Cofactors: right where the inverse does not exist. Their size is that of the scale squared: taken out in double.
    dmat3 normal =
        dmat3(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]), glm::cross(linear[0], linear[1]));
    const double size = std::sqrt(
        std::max({glm::dot(normal[0], normal[0]), glm::dot(normal[1], normal[1]), glm::dot(normal[2], normal[2])}));
    if (size > 0.0)
        normal *= sign / size;
    return {.linear = mat3(linear),
            .translation = vec3(dvec3(eyeFromObject[3])),
            .normal = mat3(normal),
            .handedness = static_cast<float>(sign),
            .material = static_cast<std::uint32_t>(material),
            .object = static_cast<std::uint32_t>(object)};
}

shared::UvTransform uvTransform(const TextureUse& use)
{
    const auto& t = use.transform;
    return {.u = vec3(dvec3(t[0].x, t[1].x, t[2].x)), .v = vec3(dvec3(t[0].y, t[1].y, t[2].y))};
}

// What is kept is the level of one texture as it lies on the device, its sampler's bias in it where the device says the
// level. Another's is finer by the ratio of their sizes, and each by the levels that are not there.
void setLevels(shared::Material& material, const ShadingPlan& plan, const TextureSet& textures,
               std::span<const int> finestLevels)
{
    const std::optional<TextureRole> kept = levelRole(plan, textures);
    if (!kept)
        return;
    const auto textureOf = [&](TextureRole role) { return textures[static_cast<std::size_t>(role)]; };
    const auto finest = [&](int texture) { return finestLevels[static_cast<std::size_t>(texture)]; };
    const auto planned = [&](int texture) -> const PlannedTexture& {
        return plan.textures[static_cast<std::size_t>(texture)];
    };
    const PlannedTexture& keptTexture = planned(textureOf(*kept));
    const bool biased = keptTexture.sampler.mip != MipFilter::none && !brdf::computesLevel(plan.settings.methods);
    const double keptBias = biased ? levelBias(plan.settings) : 0.0;
    const auto difference = [&](TextureRole role) {
        const int texture = textureOf(role);
        return texture < 0 ? 0.0f
                           : static_cast<float>(std::log2(double(planned(texture).width) / keptTexture.width) -
                                                finest(texture) + finest(textureOf(*kept)) - keptBias);
    };
    material.levels = vec4(difference(TextureRole::baseColor), difference(TextureRole::material),
                           difference(TextureRole::normal), difference(TextureRole::emissive));
    material.occlusionLevel = difference(TextureRole::occlusion);
}

// See shared::Frame::viewFromDepth; the depth of a point is what projectionMatrix makes of it.
vec4 viewFromDepth(const Camera& camera, const dmat4& projection)
{
    const double scale = projection[2][2], offset = projection[3][2];
    return camera.kind == Camera::Kind::orthographic ? vec4(dvec4(-1.0, offset, 0.0, scale))
                                                     : vec4(dvec4(0.0, offset, 1.0, scale));
}

} // namespace

shared::Frame makeFrame(const Scene& scene, const ShadingPlan& plan, const Camera& camera, const dvec2& offset,
                        int environmentLevels, int panoramaWidth)
{
    const int width = plan.settings.width, height = plan.settings.height;
    const dmat3 viewAxes = dmat3(viewFromWorld(camera));
    const dvec3 forward = -dvec3(viewAxes[0].z, viewAxes[1].z, viewAxes[2].z);
    const bool orthographic = camera.kind == Camera::Kind::orthographic;

    dmat4 shift(1.0); // what lies at pixel p + offset is drawn at pixel p
    shift[3] = dvec4(-2.0 * offset.x / width, -2.0 * offset.y / height, 0.0, 1.0);

    const auto rayPoint = [&](double x, double y) { return linearRayPoint(camera, forward, width, height, x, y); };
    const dvec3 origin = rayPoint(0, 0);
    const dvec3 across = (rayPoint(width, 0) - origin) / double(width);
    const dvec3 down = (rayPoint(0, height) - origin) / double(height);

    shared::Frame frame = {};
    const dmat4 projection = projectionMatrix(camera, double(width) / height);
    frame.clipFromEye = mat4(shift * projection * dmat4(viewAxes));
    frame.viewFromDepth = viewFromDepth(camera, projection);
    frame.towardsEye = orthographic ? vec3(-forward) : vec3(0.0f);
    frame.eyeWeight = orthographic ? 0.0f : 1.0f;
    frame.corner = vec3(origin + offset.x * across + offset.y * down);
    frame.across = vec3(across);
    frame.down = vec3(down);
    frame.forward = vec3(forward);
    frame.orthographic = orthographic ? 1.0f : 0.0f;
    frame.environmentFromWorld = mat3(1.0f);
    if (plan.settings.view) {
        frame.viewTerm = plan.settings.view->code;
        frame.viewLight = static_cast<std::uint32_t>(plan.settings.viewLight);
    }
    if (scene.environment) {
        frame.environmentFromWorld = mat3(glm::transpose(worldFromEnvironment(scene.environment->rotation)));
        frame.environmentIntensity = static_cast<float>(scene.environment->intensity);
        frame.environmentLastLevel = static_cast<float>(std::max(environmentLevels - 1, 0));
        frame.panoramaLevel = panoramaLevel(frame, panoramaWidth);
    }
    return frame;
}

std::vector<shared::Instance> makeInstances(const ShadingPlan& plan, const MeshBuffers& meshes, const dvec3& eye)
{
    std::vector<dvec3> centers(plan.instances.size(), dvec3(0.0));
    for (const auto* list : {&plan.batches, &plan.blended})
        for (const Batch& batch : *list)
            for (const Draw& draw : batch.draws)
                for (int i = 0; draw.primitive >= 0 && i < draw.instanceCount; ++i)
                    centers[static_cast<std::size_t>(draw.firstInstance + i)] =
                        meshes.ranges[static_cast<std::size_t>(draw.primitive)].center;
    std::vector<shared::Instance> instances;
    for (std::size_t i = 0; i < plan.instances.size(); ++i) {
        dmat4 eyeFromObject = plan.instances[i].worldFromObject;
        eyeFromObject[3] = dvec4(dvec3(eyeFromObject * dvec4(centers[i], 1.0)) - eye, 1.0);
        instances.push_back(makeInstance(eyeFromObject, plan.instances[i].material, plan.instances[i].object));
    }
    return instances;
}

std::vector<shared::Material> makeMaterials(const ShadingPlan& plan, std::span<const int> finestLevels)
{
    std::vector<shared::Material> materials;
    for (const MaterialBlock& block : plan.blocks) {
        const Material& m = plan.materials[static_cast<std::size_t>(block.material)].material;
        const TextureUse* place = sharedPlace(m, block.textures);
        shared::Material result = {.baseColorFactor = vec4(m.baseColorFactor),
                                   .emissiveFactor = vec3(m.emissiveFactor),
                                   .metallicFactor = static_cast<float>(m.metallicFactor),
                                   .roughnessFactor = static_cast<float>(m.roughnessFactor),
                                   .normalScale = static_cast<float>(m.normalScale),
                                   .occlusionStrength = static_cast<float>(m.occlusionStrength),
                                   .alphaCutoff = static_cast<float>(m.alphaCutoff),
                                   .ior = static_cast<float>(m.ior),
                                   .placeUv = uvTransform(place ? *place : TextureUse{}),
                                   .baseColorUv = uvTransform(m.baseColor),
                                   .materialUv = uvTransform(m.metallicRoughness),
                                   .normalUv = uvTransform(m.normal),
                                   .occlusionUv = uvTransform(m.occlusion),
                                   .emissiveUv = uvTransform(m.emissive),
                                   .slot = static_cast<std::uint32_t>(block.slot),
                                   .levels = vec4(0.0f),
                                   .occlusionLevel = 0.0f,
                                   .wordsLevel = static_cast<float>(levelBias(plan.settings))};
        setLevels(result, plan, block.textures, finestLevels);
        materials.push_back(result);
    }
    return materials;
}

static_assert(kMostLights == shared::kMaxLights);

std::vector<shared::Light> makeLights(const ShadingPlan& plan, std::span<const brdf::LampPoint> lamps, const dvec3& eye)
{
    // The least difference of the cones' cosines, KHR_lights_punctual's own: a hard edge is a very steep one.
    constexpr double kLeastCone = 0.001;
    std::vector<shared::Light> lights;
    for (const Light& light : plan.lights) {
        shared::Light l = {};
        l.position = vec3(light.position - eye);
        l.direction = vec3(-light.direction);
        l.intensity = vec3(light.color * light.intensity);
        l.inverseRange = light.range > 0.0 ? static_cast<float>(1.0 / light.range) : 0.0f;
        l.radius = static_cast<float>(light.radius);
        const double scale =
            1.0 / std::max(kLeastCone, std::cos(light.innerConeAngle) - std::cos(light.outerConeAngle));
        l.coneScale = static_cast<float>(scale);
        l.coneOffset = static_cast<float>(-std::cos(light.outerConeAngle) * scale);
        lights.push_back(l);
    }
    for (const brdf::LampPoint& lamp : lamps) {
        shared::Light l = {};
        l.direction = vec3(lamp.direction);
        l.intensity = vec3(lamp.energy);
        l.coneScale = static_cast<float>(lamp.density);
        lights.push_back(l);
    }
    return lights;
}

} // namespace torrance
