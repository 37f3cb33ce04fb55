// Where a picture is taken from, by options that several commands share.
#pragma once

#include "scene/scene.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace torrance {

struct CameraOptions
{
    std::string orbit;                 // "THETA,PHI" or "THETA,PHI,RADIUS"
    std::string target;                // "X,Y,Z"
    std::string position;              // "X,Y,Z"
    std::optional<std::string> up;     // "+Y" (the default), "-Z", ... or "X,Y,Z"
    std::optional<double> verticalFov; // degrees, 45
    std::optional<double> margin;      // of the picture, on each side, 0.05
    int index = -1;                    // of the file's cameras, -1 = none of them
};

void declareCameraOptions(CLI::App& app, CameraOptions& options);

/// The camera for a scene and a picture's width / height: the file's (index), at a place (position), on an orbit, or
/// fitted to the scene. Error (usage) where options contradict each other or the file has no such camera.
Camera chooseCamera(const CameraOptions& options, const Scene& scene, double aspect);

} // namespace torrance
