// Where a method is looked at: the axes of its maps and the points of each cell, chosen to reach the corners.
#pragma once

#include "brdf/method.h"
#include "gpu/precision.h"

#include <string_view>
#include <vector>

namespace torrance {

/// A map has a column per cosine, NoV (VoH where the method is a Fresnel term), and a row per roughness (per index of
/// refraction, for Fresnel terms, which read no roughness). Both ascend.
struct SweepAxes
{
    std::vector<double> cosines;
    std::vector<double> rows;
    double leastLight = 0.0; // points whose NoL is below it are left out
};

struct AxisNames
{
    std::string_view cosine; // "NoV", "VoH"
    std::string_view row;    // "roughness", "ior"
};
AxisNames axisNames(brdf::Slot slot);

/// True for slots whose points need brdf::setInterface: what the other terms tell them.
bool readsInterface(brdf::Slot slot);

/// `size` columns and rows. Cosines from 1e-4 (a surface that is seen has no less: kMinNoV) to 1, and roughnesses from
/// 0 to 1, are spaced by squares, denser at grazing and on smooth surfaces. Indices lie on logarithmic scales about 1,
/// from 0.4 over 1 +- 1e-6 and 1 itself to 3.
SweepAxes sweepAxes(brdf::Slot slot, int size);

/// The points of one cell: exact directions, and a surface whose roughness and colours are numbers of the precision.
/// h lies off the normal by nothing, by 1e-7 to 1 and by parts and multiples of the highlight's width; l goes from
/// grazing to the normal; both on several sides of v. Light below the horizon is left out. Fresnel terms are given a
/// dielectric of the cell's index, and metals.
std::vector<brdf::ShadingPoint> sweepPoints(brdf::Slot slot, double cosine, double row, gpu::Precision precision);

/// The one of v and h = n at NoV, for what depends on nothing else.
brdf::ShadingPoint mirrorPoint(double NoV, double perceptualRoughness);

} // namespace torrance
