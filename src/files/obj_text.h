// The statements of an OBJ file, checked, and its geometry in the form that tinyobjloader reads without fault.
#pragma once

#include "files/load_report.h"
#include "files/scene_file.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace torrance {

/// From a face on: what it belongs to.
struct ObjRun
{
    std::size_t firstFace = 0;
    int shape = 0;               // ObjText::shapes
    int material = -1;           // ObjText::materials; -1 before the first usemtl
    std::uint32_t smoothing = 0; // group of the faces whose normals are averaged; 0 = flat
};

struct ObjText
{
    std::string geometry;               // v, vn, vt and f alone: finite numbers, indices from 1 that all exist
    std::vector<std::uint32_t> corners; // of every face, 3 or more
    std::vector<ObjRun> runs;           // by firstFace
    std::vector<std::string> shapes;    // object and group, in the order of their first faces
    std::vector<std::string> materials; // as usemtl names them, in the order of their first use
    std::vector<std::string> libraries; // what stands behind mtllib: one name with spaces, or several names
    std::size_t positions = 0;
};

/// Reads the statements of `text`. NaN and infinite numbers become 0 and are counted in the report. Lines, points and
/// free-form curves and surfaces are left out with a warning, as are faces of fewer than three corners. Errors
/// (input), with the line's number: a statement that is damaged, an index that does not exist, more than the limits
/// allow, no face at all.
ObjText readObjText(std::string_view text, const SceneLimits& limits, LoadReport& report);

} // namespace torrance
