// What the slot dfg stands for: the directional albedo terms of the glTF material's lobes.
#pragma once

#include "math/vector.h"

#include <span>
#include <string_view>

namespace torrance::brdf {

/// (scale, bias, w) of albedo.h: the integrals that the table holds at its nodes. NoV, perceptualRoughness in [0, 1].
dvec3 DFG_table(double NoV, double perceptualRoughness);

/// Fits in closed form, scale and bias as published, each with the roughness of its own lobe found from ours (the rows
/// of the registry say from which). A bias below zero, which Lazarov's and Karis' have where F0 is far below 0.04, is
/// theirs: F0 scale + bias is not negative for F0 >= 0.04, and whoever uses them for less ends it at zero. All lack w
/// and have fittedDiffuseWeight for it; their E is scale + bias.
dvec3 DFG_lazarov(double NoV, double perceptualRoughness);
dvec3 DFG_karis_mobile(double NoV, double perceptualRoughness);
dvec3 DFG_narkowicz(double NoV, double perceptualRoughness);

/// The polynomial of degree 5 that meets schlickDiffuseWeight at the Chebyshev nodes of [0, 1]: within 6e-6 of it.
double fittedDiffuseWeight(double NoV);

/// How a row of the slot that is a table is stored on the device.
enum class DfgFormat
{
    float32,
    float16,
    unorm16,
};

struct DfgStorage
{
    std::string_view id;
    int width;  // nodes along NoV
    int height; // along roughness
    DfgFormat format;
};

std::span<const DfgStorage> allDfgTables();
/// Null for a fit.
const DfgStorage* findDfgTable(std::string_view id);

/// E = scale + bias. The last one is kept, per thread: whoever integrates over l asks for the same one each time, and
/// it takes ten thousand times as long as a BRDF.
double lobeAlbedo(double NoV, double perceptualRoughness);

} // namespace torrance::brdf
