#include "view/orbit_pose.h"

#include "scene/camera_view.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace torrance {
namespace {

constexpr double kDegree = kPi / 180.0;

// In the order in which the command line's numbers are multiplied: `torrance render` makes the same bits of them.
double radians(double degrees)
{
    return degrees * kPi / 180.0;
}

OrbitAngles anglesOf(const OrbitPose& pose)
{
    return {.theta = radians(pose.theta), .phi = radians(pose.phi), .up = pose.up};
}

Camera bareCamera(const OrbitPose& pose)
{
    return orbitCamera(anglesOf(pose), pose.radius, pose.target, radians(pose.verticalFov));
}

// What the angles are measured from, for this `up`.
struct Axes
{
    dvec3 front, right, up;
};

Axes axesOf(const dvec3& up)
{
    const auto direction = [&](double theta, double phi) {
        return cameraPosition(orbitCamera({.theta = theta, .phi = phi, .up = up}, 1.0, dvec3(0.0), 1.0));
    };
    return {direction(0.0, kPi / 2.0), direction(kPi / 2.0, kPi / 2.0), direction(0.0, 0.0)};
}

void setDirection(OrbitPose& pose, const dvec3& fromTarget)
{
    const Axes axes = axesOf(pose.up);
    const dvec3 d(glm::dot(fromTarget, axes.right), glm::dot(fromTarget, axes.up), glm::dot(fromTarget, axes.front));
    pose.phi = std::atan2(std::hypot(d.x, d.z), d.y) / kDegree;
    if (d.x != 0.0 || d.z != 0.0) // at a pole the meridian stays what it was
        pose.theta = std::atan2(d.x, d.z) / kDegree;
}

double wrapped(double degrees)
{
    return degrees - 360.0 * std::floor((degrees + 180.0) / 360.0);
}

dmat3 axesOfCamera(const Camera& camera)
{
    return glm::transpose(dmat3(viewFromWorld(camera))); // columns: right, up, backward
}

std::string triple(const dvec3& v)
{
    return fmt::format("{},{},{}", v.x, v.y, v.z);
}

} // namespace

Camera cameraOf(const OrbitPose& pose, const Scene& scene)
{
    return fitNearPlane(bareCamera(pose), scene);
}

OrbitPose poseOf(const Camera& camera, const dvec3& pivot)
{
    const dmat3 axes = axesOfCamera(camera);
    const dvec3 eye = cameraPosition(camera), forward = -axes[2];
    const double along = glm::dot(pivot - eye, forward);
    OrbitPose pose;
    pose.radius = along > 0.0 ? along : 1.0;
    pose.verticalFov = camera.verticalFov / kDegree;
    if (camera.kind == Camera::Kind::orthographic)
        pose.verticalFov = 2.0 * std::atan2(camera.ymag, pose.radius) / kDegree;
    pose.target = eye + pose.radius * forward;
    setDirection(pose, -forward);
    constexpr double kRoll = 1e-6; // of a unit vector: what remains of a level camera after its matrix was rounded
    if (glm::length(axesOfCamera(bareCamera(pose))[0] - axes[0]) > kRoll) {
        pose.up = axes[1];
        setDirection(pose, -forward);
    }
    return pose;
}

void orbit(OrbitPose& pose, double theta, double phi)
{
    pose.theta = wrapped(pose.theta + theta);
    pose.phi = std::clamp(pose.phi + phi, 0.0, 180.0);
}

void pan(OrbitPose& pose, double right, double upwards)
{
    const dmat3 axes = axesOfCamera(bareCamera(pose));
    const double height = 2.0 * pose.radius * std::tan(0.5 * pose.verticalFov * kDegree);
    pose.target += height * (right * axes[0] + upwards * axes[1]);
}

void dolly(OrbitPose& pose, double factor, double diagonal)
{
    pose.radius = std::clamp(pose.radius * factor, kNearestRadius * diagonal, kFarthestRadius * diagonal);
}

void fly(OrbitPose& pose, double forward, double right)
{
    const dmat3 axes = axesOfCamera(bareCamera(pose));
    pose.target += pose.radius * (right * axes[0] - forward * axes[2]);
}

void lookAt(OrbitPose& pose, const dvec3& target)
{
    const dvec3 fromTarget = cameraPosition(bareCamera(pose)) - target;
    const double radius = glm::length(fromTarget);
    if (!(radius > 0.0))
        return; // the camera stands there
    pose.target = target;
    pose.radius = radius;
    setDirection(pose, fromTarget / radius);
}

std::vector<std::string> cameraArguments(const OrbitPose& pose)
{
    std::vector<std::string> arguments = {fmt::format("--orbit={},{},{}", pose.theta, pose.phi, pose.radius),
                                          "--target=" + triple(pose.target), fmt::format("--fov={}", pose.verticalFov)};
    if (pose.up != dvec3(0.0, 1.0, 0.0))
        arguments.push_back("--up=" + triple(pose.up));
    return arguments;
}

} // namespace torrance
