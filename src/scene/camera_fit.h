// Where to put a camera: on a sphere about a target, or as close as the whole scene fits the picture.
#pragma once

#include "scene/scene.h"

namespace torrance {

/// A direction of view in spherical coordinates, radians: theta about `up` from the front, phi from `up`. With up = +Y
/// the front is +Z, so that (0, pi/2) looks at the front of a glTF asset. For another `up` the axes are turned the
/// shortest way (+Z up: the front is -Y, as in Blender); up = -Y turns them about +Z. `up` need not be unit; one that
/// is zero or not finite counts as +Y.
struct OrbitAngles
{
    double theta = 0.0;
    double phi = kPi / 2.0;
    dvec3 up = dvec3(0.0, 1.0, 0.0);
};

/// A perspective camera at `radius` from `target`, looking at it. Well defined at the poles phi = 0 and pi too, where
/// it is the limit along the meridian theta. verticalFov in (0, pi). The near plane is left to fitNearPlane.
Camera orbitCamera(const OrbitAngles& angles, double radius, const dvec3& target, double verticalFov);

/// A camera at `position` that looks at `target`. Where `up` is parallel to the view, another axis takes its place.
Camera lookAtCamera(const dvec3& position, const dvec3& target, const dvec3& up, double verticalFov);

/// The nearest camera with this direction of view that has every vertex of every instance and every analytic shape
/// inside the picture shrunk by `margin` (|ndc| <= 1 - margin, 0 <= margin < 1); what it sees is centred in both axes,
/// and touches the margin on at least one. Non-finite vertices do not count. A scene without extent is fitted as a
/// sphere of radius kPointExtent about its point (the origin where the scene is empty). Flat and pointed scenes keep
/// kLeastClearance of their size between the camera and the nearest vertex: on the line of sight a needle would
/// otherwise touch the eye.
Camera fitCamera(const Scene& scene, const OrbitAngles& angles, double aspect, double verticalFov, double margin);

inline constexpr double kPointExtent = 1.0;     // metres
inline constexpr double kLeastClearance = 0.01; // of the diagonal of the scene's bounds

/// The camera with its near plane half way to the nearest point of the scene's bounds in front of it, and at least
/// kLeastNear of the bounds' diagonal where the camera is inside them. Depth is reversed float: a near plane this close
/// costs no precision. A far plane that the camera has is kept, with the near plane before it. Perspective cameras.
Camera fitNearPlane(const Camera& camera, const Scene& scene);

inline constexpr double kLeastNear = 1e-4; // of the diagonal of the scene's bounds

struct Bounds
{
    dvec3 min = dvec3(0.0);
    dvec3 max = dvec3(0.0);
    bool empty = true;
};

/// Of the transformed vertices that an index names and of the shapes, in the world.
Bounds worldBounds(const Scene& scene);

} // namespace torrance
