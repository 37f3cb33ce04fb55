// The vertices and corners of an OBJ file, as tinyobjloader reads them.
#pragma once

#include "files/obj_text.h"
#include "math/vector.h"

namespace torrance {

/// Numbers of ObjGeometry's arrays; -1 = none.
struct ObjCorner
{
    int position = 0;
    int uv = -1;
    int normal = -1;
};

struct ObjGeometry
{
    std::vector<vec3> positions;
    std::vector<vec3> colors; // of the positions, as stored; empty unless all have one
    std::vector<vec3> normals;
    std::vector<vec2> uvs;          // v up, as the format has it
    std::vector<ObjCorner> corners; // face by face, ObjText::corners of each
};

/// Parses `text.geometry`.
ObjGeometry parseGeometry(const ObjText& text);

} // namespace torrance
