// Where the window looks from, as it is moved by hand. Angles are degrees and numbers are those of the command line, so
// that `torrance render` draws the same picture from them.
#pragma once

#include "scene/camera_fit.h"
#include "scene/default_view.h"

#include <string>
#include <vector>

namespace torrance {

/// A camera on a sphere about what it looks at.
struct OrbitPose
{
    double theta = kDefaultTheta; // degrees about `up` from the front, in [-180, 180)
    double phi = kDefaultPhi;     // degrees from `up`, in [0, 180]
    double radius = 1.0;          // scene units, above 0
    dvec3 target = dvec3(0.0);
    dvec3 up = dvec3(0.0, 1.0, 0.0);
    double verticalFov = kDefaultFov; // degrees
};

/// The least and the greatest radius, of the diagonal of the scene's bounds: nearer, single floats fill the picture;
/// farther, the scene is less than a pixel.
inline constexpr double kNearestRadius = 1e-5, kFarthestRadius = 1e4;

Camera cameraOf(const OrbitPose& pose, const Scene& scene);

/// The pose that has a camera's place and line of sight, and its roll where `up` can hold it; its target is the point
/// of that line nearest to `pivot`, or one unit away where that lies behind the camera. An orthographic camera becomes
/// the perspective one that sees as much at the target.
OrbitPose poseOf(const Camera& camera, const dvec3& pivot);

/// Turns about the target, degrees; phi stops at the poles.
void orbit(OrbitPose& pose, double theta, double phi);

/// Moves the target across the view: parts of the picture's height at the target's distance, to the right and upwards.
void pan(OrbitPose& pose, double right, double upwards);

/// Multiplies the distance to the target. `diagonal` is that of the scene's bounds, and limits it.
void dolly(OrbitPose& pose, double factor, double diagonal);

/// Moves camera and target along the line of sight and to the right: parts of the distance to the target.
void fly(OrbitPose& pose, double forward, double right);

/// Looks at another point from the same place.
void lookAt(OrbitPose& pose, const dvec3& target);

/// The pose in the words of `torrance render`.
std::vector<std::string> cameraArguments(const OrbitPose& pose);

} // namespace torrance
