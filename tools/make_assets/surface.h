// Surfaces as functions of two parameters, and the meshes made from them.
#pragma once

#include "math/vector.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace torrance::assets {

/// u runs to the right and v runs down, seen from the side that the normal points to; both in [0, 1].
struct SurfacePoint
{
    dvec3 position;
    dvec3 normal;
    dvec3 tangent; // along u
    dvec2 uv;      // texture coordinates of the material
};

struct Surface
{
    std::function<SurfacePoint(double u, double v)> at;
    std::vector<double> us; // where its grid has columns and rows, rising from 0 to 1
    std::vector<double> vs;
};

/// A place in the occlusion atlas, in texels. The first and the last texel's middles are u (or v) 0 and 1.
struct Chart
{
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

struct Mesh
{
    std::vector<vec3> positions;
    std::vector<vec3> normals;
    std::vector<vec4> tangents;
    std::vector<vec2> uvs;    // the material's
    std::vector<vec2> charts; // the occlusion atlas's
    std::vector<std::uint32_t> indices;
};

/// n + 1 even steps from 0 to 1.
std::vector<double> evenSteps(int n);

/// Appends the surface's grid. Triangles without area (at poles) are left out.
void appendSurface(Mesh& mesh, const Surface& surface, const Chart& chart, int atlasSize);

/// A surface from positions alone: normals and tangents by central differences, uv = (u, v). Where a derivative
/// vanishes (at poles) it is taken a little inside.
Surface surfaceFromPositions(std::function<dvec3(double u, double v)> position, int columns, int rows);

} // namespace torrance::assets
