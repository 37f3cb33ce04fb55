// V = G / (4 NoV NoL), without unit: shadowing and masking with the denominator of the microfacet BRDF. Zero where v or
// l is not above the surface. Read from a point: NoV, NoL, NoH, VoH, alpha, perceptualRoughness.
#pragma once

#include "brdf/shading_point.h"

namespace torrance::brdf {

double V_smith_corr(const ShadingPoint& point);
double V_smith_uncorr(const ShadingPoint& point);
double V_hammon(const ShadingPoint& point);
double V_schlick_half(const ShadingPoint& point);
double V_schlick_direct(const ShadingPoint& point);
double V_vcavity(const ShadingPoint& point);
double V_kelemen(const ShadingPoint& point);
double V_neumann(const ShadingPoint& point);
double V_implicit(const ShadingPoint& point);

} // namespace torrance::brdf
