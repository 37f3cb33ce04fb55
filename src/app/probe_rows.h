// The table that `torrance probe` reads: one shading point per row.
#pragma once

#include "brdf/shading_point.h"

#include <string>
#include <string_view>
#include <vector>

namespace torrance {

struct ProbeRows
{
    std::vector<std::string> ids;
    std::vector<brdf::ShadingPoint> points;
    std::string nonUnit; // the first direction whose length is not 1 within kUnitTolerance: "line 4, column nx ny nz"
};

/// Directions printed with three digits pass. All are made unit; beyond this, somebody may have meant something else.
inline constexpr double kUnitTolerance = 2e-3;

/// What a term reads beside n, v, l and roughness: columns that must then be there.
struct ProbeColumns
{
    bool baseColor = false; // base_r, base_g, base_b
    bool metallic = false;
    bool ior = false;
    bool conductor = false; // eta, k
    bool f82 = false;       // f82_r, f82_g, f82_b
    bool tangent = false;   // tx, ty, tz, anisotropy
};

/// Columns id, nx ny nz, vx vy vz, lx ly lz (any length but zero), roughness, and those of `columns`; others are
/// ignored. f0 = 0.04 and f90 = 1. Errors (input) name `file`, the line and the column: missing columns, what is no
/// finite number, vectors of zero length, tangents along n, roughness, metallic, anisotropy outside [0, 1], base
/// colour, ior, eta, k, f82 outside [0, 1e6].
ProbeRows parseProbeRows(std::string_view csv, const std::string& file, const ProbeColumns& columns);

} // namespace torrance
