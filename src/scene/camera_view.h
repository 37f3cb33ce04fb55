// What a camera sees: its matrices and the rays through its pixels, in double. Everything is relative to the camera's
// position, so that a scene a million metres from the origin keeps its small distances when it is rounded to float.
#pragma once

#include "math/ray.h"
#include "scene/scene.h"

namespace torrance {

/// Where the camera stands, in the world.
dvec3 cameraPosition(const Camera& camera);

/// World to view space: the camera at the origin, looking along -Z, +Y up. worldFromCamera is taken as rigid (glTF: a
/// camera's own scale does not count): its columns are made orthonormal first.
dmat4 viewFromWorld(const Camera& camera);

/// View space to Vulkan clip space for a picture of this width / height: x right, y down, depth 1 at the near plane and
/// 0 at the far plane. A perspective camera whose farPlane is 0 sees infinitely far. The vertical field of view (or
/// ymag) is kept where the file's camera asked for another aspect. Requires aspect > 0, 0 < nearPlane (perspective),
/// nearPlane < farPlane (where there is a far plane; an orthographic camera always has one).
dmat4 projectionMatrix(const Camera& camera, double aspect);

/// The ray through the point (x, y) of a picture, in pixels from its top-left corner: the centre of the first pixel is
/// (0.5, 0.5). Directions are those of the world, the origin is relative to cameraPosition: (0, 0, 0) for a perspective
/// camera.
Ray primaryRay(const Camera& camera, int width, int height, double x, double y);

} // namespace torrance
