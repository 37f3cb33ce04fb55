// Tables of a lobe's directional albedo that the device looks up: glTF's (D ggx, V smith_corr, Schlick), and source B's
// BRDF integration map.
#pragma once

#include "brdf/method.h"

#include <filesystem>
#include <vector>

namespace torrance {

/// Texels (scale, bias, w, E) of brdf/albedo.h, E = scale + bias, or (x, y, z, x + y) of brdf/integration_map.h; row by
/// row, roughness 0 first, in each row NoV 0 first.
struct DfgTable
{
    int width = 0;             // along NoV
    int height = 0;            // along roughness
    std::vector<float> texels; // width * height * 4
};

inline constexpr int kDfgWidth = 320;
inline constexpr int kDfgHeight = 160;
inline constexpr int kIntegrationMapSize = 128; // either side of source B's

/// Where (NoV, perceptual roughness) lies, both in [0, 1]: x = 0.78 sqrt(NoV) + 0.22 NoV^4, y = sqrt(r). 0 and 1 are
/// the CENTRES of the first and the last texel. The root follows E, which turns within NoV ~ alpha; the fourth power
/// follows w, which falls steeply towards NoV = 1. In GLSL, with the table's size:
///     vec2 p = vec2(0.78 * sqrt(NoV) + 0.22 * NoV * NoV * NoV * NoV, sqrt(r));
///     vec4 dfg = texture(table, (p * (size - 1.0) + 0.5) / size);
/// Devices whose filter has 8-bit weights (many GPUs; not lavapipe) add up to 1/512 of the step between texels, 1e-4;
/// mix four texelFetch where that matters.
dvec2 dfgCoordinates(double NoV, double perceptualRoughness);
/// Their inverses: NoV at x, roughness at y.
double dfgNoV(double x);
double dfgRoughness(double y);

/// Computes the table on all cores. Each node stands half of the interpolation's error on its sides below the exact
/// value, so that a bilinear lookup errs alike in the middle of a cell and at its corners. Of brdf::DFG_table: within
/// 1e-4 relative of the exact scale * F0 + bias for F0 in [0.04, 1], r >= 0.1, NoV >= 1e-3 or r >= 0.05, NoV >= 0.05;
/// and of w. Of brdf::integrationMap at kIntegrationMapSize: x, y and z within 1e-4.
DfgTable makeDfgTable(brdf::DfgFormula formula, int width = kDfgWidth, int height = kDfgHeight);

/// Bilinear lookup in float, as the device does it.
vec4 lookUpDfg(const DfgTable& table, float NoV, float perceptualRoughness);

/// The file that the build makes: share/torrance/dfg_ggx_smith_corr.bin. Reading throws an Error (input) where it is
/// missing, cut short or altered.
void writeDfgTable(const std::filesystem::path& path, const DfgTable& table);
DfgTable readDfgTable(const std::filesystem::path& path);

} // namespace torrance
