// Normals of a primitive that the file leaves out or gives without a direction.
#pragma once

#include "scene/scene.h"

namespace torrance {

/// glTF 2.0, 3.7.2.1: without normals a triangle is flat. Every corner becomes a vertex of its own with the normal of
/// its triangle (counter-clockwise is the front), and tangents are dropped. A triangle without area gets +Z.
void makeFlat(Primitive& primitive);

/// Scales every normal to unit length. One of length zero becomes the area-weighted mean of the triangles around its
/// vertex, or +Z where that has no direction either. Returns how many those were.
std::size_t normalizeNormals(Primitive& primitive);

/// Scales tangents to unit length and their sign to 1 or -1. False where one has no direction: such tangents are none.
bool normalizeTangents(Primitive& primitive);

} // namespace torrance
