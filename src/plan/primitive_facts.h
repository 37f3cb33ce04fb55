// What can be known of a primitive without drawing it.
#pragma once

#include "scene/scene.h"

namespace torrance {

/// Whether the normals of some triangle may cancel where they are interpolated, or one of them is zero: where no two of
/// a triangle point more than a right angle apart, no mixture of them is zero.
bool normalsMayVanish(const Primitive& primitive);

/// Whether the triangles are the whole surface of a body that can be seen in one piece from the middle of its box,
/// their fronts outside: then no back is ever seen from outside of it, whether or not it is drawn. Tested, vertices at
/// one place taken as one and triangles with two corners at one place left out: every edge joins two triangles that run
/// along it in opposite senses, each triangle shows its back to the middle, and a ray from the middle meets one. The
/// projection to a sphere round the middle is then a covering of one sheet, so that the surface does not cross itself,
/// and a ray from outside enters the body through a front before it meets a back.
bool isStarBody(const Primitive& primitive);

} // namespace torrance
