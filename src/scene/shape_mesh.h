// The shapes that a material is shown on, as triangles with normals, texture coordinates and tangents.
#pragma once

#include "scene/scene.h"

namespace torrance {

/// Quads of the sphere: the middle of an edge along the equator lies 1 - cos(pi / kSphereSegments) = 7.5e-5 radii below
/// the surface, that of a quad twice as much. Normals and tangents are the sphere's own at every vertex.
inline constexpr int kSphereSegments = 256;
inline constexpr int kSphereRings = 128;

/// Radius 1 about the origin. u runs once round +Y, 0.5 at +Z and growing towards +X; v from +Y (0) to -Y (1).
Primitive sphereMesh();

/// |x| <= 1, |y| <= 1, z = 0, facing +Z; uv (0, 0) at its upper left.
Primitive planeMesh();

/// |x|, |y|, |z| <= 1; every face has the whole texture, upright where it stands.
Primitive cubeMesh();

} // namespace torrance
