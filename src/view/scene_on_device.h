// A scene, what is computed for it, and what lies of it on the device: what the window shows.
#pragma once

#include "files/scene_file.h"
#include "passes/renderer.h"
#include "reference/ray_caster.h"
#include "scene/camera_fit.h"
#include "view/background_task.h"
#include "view/scene_source.h"

#include <memory>
#include <string>

namespace torrance {

struct SceneOnDevice
{
    std::string input;                   // as it was named: a file, or a built-in scene
    std::shared_ptr<SceneSource> source; // shared with what saves it meanwhile
    LoadedScene loaded;
    Bounds bounds;
    ShadingPlan plan;
    std::unique_ptr<DeviceScene> device; // refers to the scene and the plan above
    dvec3 rayOrigin = dvec3(0.0);
    std::unique_ptr<RayCaster> rays; // relative to rayOrigin; refers to the scene above

    SceneOnDevice() = default;
    SceneOnDevice(const SceneOnDevice&) = delete;
    SceneOnDevice& operator=(const SceneOnDevice&) = delete;

    Scene& scene() { return loaded.scene; }
    const Scene& scene() const { return loaded.scene; }
};

/// The parts of opening a scene, for a progress bar.
enum OpeningPart
{
    kReading,
    kPlanning,
    kUploading,
    kOpeningParts,
};

/// Plans and uploads a scene that was read, beside whatever the renderer draws meanwhile. Throws Cancelled at the next
/// part, or after the next texture.
std::unique_ptr<SceneOnDevice> putOnDevice(Renderer& renderer, LoadedScene loaded, const std::string& input,
                                           const Settings& settings, Progress& progress);

/// Plans the scene again, after it or the settings were changed. Throws Error, and the old plan stays.
void replan(Renderer& renderer, SceneOnDevice& scene, const Settings& settings);

/// The nearest surface under a pixel of a picture (in pixels from its top left); nothing where there is none. The holes
/// of alpha masks count as surface.
struct Picked
{
    int instance = -1; // Scene::instances, or -1
    int shape = -1;    // Scene::shapes, or -1
    dvec3 position = dvec3(0.0);
};
std::optional<Picked> pick(const SceneOnDevice& scene, const Camera& camera, const ivec2& pictureSize, double x,
                           double y);

} // namespace torrance
