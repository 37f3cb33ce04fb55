// The whole BRDF of the glTF 2.0 material, Appendix B, from one method per slot.
#pragma once

#include "brdf/method.h"

namespace torrance::brdf {

/// Normal reflectance of the dielectric part: index 1.5 (glTF 2.0, Appendix B).
inline constexpr double kDielectricF0 = 0.04;
inline constexpr double kDielectricIor = 1.5;

/// BRDF in 1/sr per colour channel, without the cosine NoL; 0 where v or l is not above the surface. Reads baseColor,
/// metallic and what the methods need of the geometry; f0, f90, ior, eta, k and E are set here (E to lobeAlbedo(NoV,
/// r)). The Fresnel term must be one of f0 (`schlick`): a metal's base colour is a reflectance and gives no index.
/// Otherwise an Error (usage) says so.
dvec3 evaluateBrdf(const Preset& preset, const ShadingPoint& point);

/// Throws that Error. Called by everything that builds the whole BRDF from a preset.
void requireWholeBrdf(const Preset& preset);

} // namespace torrance::brdf
