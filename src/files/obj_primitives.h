// The primitives of an OBJ file: its polygons as indexed triangles, one primitive per shape and material.
#pragma once

#include "files/obj_geometry.h"
#include "scene/scene.h"

namespace torrance {

struct ObjPrimitive
{
    Primitive primitive; // material: ObjText::materials, -1 = none
    int shape = 0;       // ObjText::shapes
};

/// In the order of their first faces. Texture coordinates get v down. Vertex colours are decoded from sRGB, as those
/// who write them mean them. A corner without a normal gets the area-weighted mean over the faces round its vertex of
/// the same smoothing group, or its polygon's own normal where the group is off. Errors (input): more vertices than
/// the limits allow, polygons too intricate to be cut.
std::vector<ObjPrimitive> buildPrimitives(const ObjText& text, const ObjGeometry& geometry, const SceneLimits& limits,
                                          LoadReport& report);

} // namespace torrance
