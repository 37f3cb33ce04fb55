// Tangents for normal maps whose mesh brings none, in the space that baking tools assume (Mikkelsen, Simulation of
// Wrinkled Surfaces Revisited, 2008, and its standard known as MikkTSpace).
#pragma once

#include "scene/scene.h"

namespace torrance {

/// The primitive with tangents of the mapping uv' = uvTransform * (uvs[uvSet], 1): xyz is unit, perpendicular to the
/// normal and points along growing u'; w is the sign of the bitangent cross(normal, tangent) * w, which points along
/// falling v' (glTF: v runs down the picture, a normal map's green up).
///
/// In: triangles with normals and the uv set; an index past the vertices is the caller's error (asserted). Out: the
/// same triangles in the same order; a vertex on a seam of the tangents is split, an unused one dropped; vertices are
/// numbered by first use. A triangle with no area, in space or in the map, takes the tangents of its neighbours at each
/// corner; where there is none, any direction perpendicular to the normal, w = 1. Non-finite positions and coordinates
/// count as such.
Primitive makeTangents(const Primitive& primitive, int uvSet, const glm::dmat3x2& uvTransform);

} // namespace torrance
