#include "view/scene_on_device.h"

#include "scene/camera_view.h"

namespace torrance {
namespace {

constexpr const Camera* kAnyCamera = nullptr;

} // namespace

std::unique_ptr<SceneOnDevice> putOnDevice(Renderer& renderer, LoadedScene loaded, const std::string& input,
                                           const Settings& settings, Progress& progress)
{
    auto result = std::make_unique<SceneOnDevice>();
    result->input = input;
    result->source = std::make_shared<SceneSource>(input);
    result->loaded = std::move(loaded);
    result->bounds = worldBounds(result->scene());
    progress.enter(kPlanning);
    result->plan = makePlan(result->scene(), settings);
    if (!result->bounds.empty)
        result->rayOrigin = 0.5 * (result->bounds.min + result->bounds.max);
    result->rays = std::make_unique<RayCaster>(result->scene(), result->rayOrigin);
    progress.enter(kUploading);
    const std::stop_token stop = progress.stopToken();
    const TexelsRead asksBetweenTextures = [&](int) { endWhereStopped(stop); };
    result->device =
        std::make_unique<DeviceScene>(renderer.upload(result->scene(), result->plan, kAnyCamera, asksBetweenTextures));
    return result;
}

void replan(Renderer& renderer, SceneOnDevice& scene, const Settings& settings)
{
    ShadingPlan plan = makePlan(scene.scene(), settings);
    // The new scene on the device refers to the plan in its place; until then the old one is needed to compare.
    std::swap(scene.plan, plan);
    try {
        const DeviceScene old = {.scene = scene.scene(),
                                 .plan = plan,
                                 .meshes = scene.device->meshes,
                                 .textures = scene.device->textures,
                                 .environments = scene.device->environments,
                                 .materials = {},
                                 .classMaterials = {}};
        scene.device = std::make_unique<DeviceScene>(renderer.replan(old, scene.plan));
    } catch (...) {
        std::swap(scene.plan, plan);
        throw;
    }
}

std::optional<Picked> pick(const SceneOnDevice& scene, const Camera& camera, const ivec2& pictureSize, double x,
                           double y)
{
    Ray ray = primaryRay(camera, pictureSize.x, pictureSize.y, x, y);
    ray.origin += cameraPosition(camera) - scene.rayOrigin;
    const std::optional<Hit> hit = scene.rays->closest(ray);
    if (!hit)
        return std::nullopt;
    return Picked{.instance = hit->instance,
                  .shape = hit->shape,
                  .position = ray.origin + hit->distance * ray.direction + scene.rayOrigin};
}

} // namespace torrance
