// D: density of microfacet normals per solid angle and macroscopic area, 1/sr. Read from a point: NoH, sin2H, alpha,
// and, where it is anisotropic, ToH, BoH, alphaT, alphaB instead of sin2H and alpha; h lies in the upper half.
#pragma once

#include "brdf/shading_point.h"

namespace torrance::brdf {

double D_ggx(const ShadingPoint& point);
double D_ggx_textbook(const ShadingPoint& point);
double D_beckmann(const ShadingPoint& point);
double D_blinn(const ShadingPoint& point);
double D_ggx_aniso(const ShadingPoint& point);

} // namespace torrance::brdf
