#include "app/camera_options.h"

#include "app/option_value.h"
#include "core/error.h"
#include "scene/camera_fit.h"
#include "scene/default_view.h"

#include <CLI/CLI.hpp>
#include <cmath>

namespace torrance {
namespace {

dvec3 parseUp(const std::string& text)
{
    constexpr std::string_view kAxes = "XYZxyz";
    const bool isSigned = text.size() == 2 && (text[0] == '+' || text[0] == '-');
    if ((text.size() == 1 || isSigned) && kAxes.find(text.back()) != std::string_view::npos) {
        dvec3 up(0.0);
        up[static_cast<int>(kAxes.find(text.back()) % 3)] = text[0] == '-' ? -1.0 : 1.0;
        return up;
    }
    const std::vector<double> v = parseNumbers("--up", text, 3, 3);
    const dvec3 up(v[0], v[1], v[2]);
    if (glm::length(up) == 0.0)
        throw usageError("--up " + text + " has no direction", "give an axis such as +Y or three numbers");
    return up;
}

dvec3 parsePoint(const char* option, const std::string& text)
{
    const std::vector<double> v = parseNumbers(option, text, 3, 3);
    return {v[0], v[1], v[2]};
}

// Every option that would have no effect is refused: none is silently ignored.
void checkTogether(const CameraOptions& o)
{
    if (!o.orbit.empty() && !o.position.empty())
        throw usageError("--orbit and --camera-position exclude each other", "give one of them");
    const bool placed = !o.orbit.empty() || !o.position.empty() || !o.target.empty();
    if (o.index >= 0 && (placed || o.up || o.verticalFov || o.margin))
        throw usageError("--camera-index takes the camera as it stands in the file",
                         "leave out the other camera options");
    if (o.margin && (!o.position.empty() || !o.target.empty()))
        throw usageError("--margin is for fitting the picture to the scene",
                         "leave it out where the camera has a place");
}

void checkRanges(const CameraOptions& o)
{
    const double fov = o.verticalFov.value_or(kDefaultFov), margin = o.margin.value_or(kDefaultMargin);
    if (!(fov > 0.0 && fov < 180.0))
        throw usageError("--fov must lie between 0 and 180 degrees", "45 is the default");
    if (!(margin >= 0.0 && margin < 0.5))
        throw usageError("--margin must be at least 0 and below 0.5", "0.05 is the default");
}

Camera fileCamera(const Scene& scene, int index)
{
    if (static_cast<std::size_t>(index) >= scene.cameras.size())
        throw usageError("--camera-index " + std::to_string(index) + ": " + scene.name + " has " +
                             std::to_string(scene.cameras.size()) + " cameras",
                         "leave it out to fit the picture to the scene");
    return scene.cameras[static_cast<std::size_t>(index)];
}

dvec3 sceneCenter(const Scene& scene)
{
    const Bounds bounds = worldBounds(scene);
    return bounds.empty ? dvec3(0.0) : 0.5 * (bounds.min + bounds.max);
}

} // namespace

void declareCameraOptions(CLI::App& app, CameraOptions& options)
{
    const char* group = "Camera";
    app.add_option("--orbit", options.orbit,
                   "Look at the target from THETA,PHI[,RADIUS]: degrees about +Y from +Z and from +Y, scene units; "
                   "without a radius the scene is fitted")
        ->group(group)
        ->type_name("THETA,PHI[,RADIUS]");
    app.add_option("--target,--camera-target", options.target,
                   "What the camera looks at (default: the middle of the scene)")
        ->group(group)
        ->type_name("X,Y,Z");
    app.add_option("--camera-position", options.position, "Where the camera stands")->group(group)->type_name("X,Y,Z");
    app.add_option("--camera-index", options.index, "Take this camera of the file, from 0 (-1: none)")
        ->group(group)
        ->check(CLI::Range(-1, 1 << 20));
    app.add_option("--fov", options.verticalFov, "Vertical field of view in degrees (default 45)")->group(group);
    app.add_option("--margin", options.margin,
                   "Empty part of the picture on each side when the scene is fitted (default 0.05)")
        ->group(group);
    app.add_option("--up", options.up, "Axis that points up in the picture: +Y, -Z, ... or three numbers")
        ->group(group)
        ->type_name("AXIS");
}

Camera chooseCamera(const CameraOptions& o, const Scene& scene, double aspect)
{
    checkTogether(o);
    checkRanges(o);
    if (o.index >= 0)
        return fitNearPlane(fileCamera(scene, o.index), scene);
    const double fov = o.verticalFov.value_or(kDefaultFov) * kPi / 180.0;
    const dvec3 up = parseUp(o.up.value_or("+Y"));
    const dvec3 target = o.target.empty() ? sceneCenter(scene) : parsePoint("--target", o.target);
    if (!o.position.empty())
        return fitNearPlane(lookAtCamera(parsePoint("--camera-position", o.position), target, up, fov), scene);
    std::vector<double> orbit = {kDefaultTheta, kDefaultPhi};
    if (!o.orbit.empty())
        orbit = parseNumbers("--orbit", o.orbit, 2, 3);
    const OrbitAngles angles = {.theta = orbit[0] * kPi / 180.0, .phi = orbit[1] * kPi / 180.0, .up = up};
    if (orbit.size() == 3) {
        if (o.margin)
            throw usageError("--orbit with a radius leaves --margin without effect", "leave out one of them");
        if (!(orbit[2] > 0.0))
            throw usageError("--orbit: the radius must be above 0", "leave it out to fit the scene");
        return fitNearPlane(orbitCamera(angles, orbit[2], target, fov), scene);
    }
    if (!o.target.empty())
        throw usageError("--target needs a distance", "give --orbit THETA,PHI,RADIUS or --camera-position");
    return fitCamera(scene, angles, aspect, fov, 2.0 * o.margin.value_or(kDefaultMargin));
}

} // namespace torrance
