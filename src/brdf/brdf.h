// The whole BRDF of a preset: the terms of its model.
#pragma once

#include "brdf/brdf_terms.h"
#include "brdf/method.h"

namespace torrance::brdf {

/// Normal reflectance of the dielectric part: index 1.5 (glTF 2.0, Appendix B).
inline constexpr double kDielectricF0 = 0.04;
inline constexpr double kDielectricIor = 1.5;

/// All terms at a point; zero where v or l is not above the surface, but for a source that says otherwise (phong).
/// Reads baseColor, metallic, ior (of the dielectric part) and what the methods need of the geometry; f0, f90, f82, the
/// albedos, what the interface reflects and the alphas of both axes are set here (f82 to white, for a glTF metal has
/// one colour; E to lobeTerms(NoV, r), or where the point asks for it or the method also reads that of the light to
/// the table's, within 1e-6: lobe_albedo_table.h; the alphas to alpha). Of the model `gltf` the Fresnel term must be
/// one of a reflectance (Interface): a metal's base colour gives no index. Otherwise an Error (usage) says so.
BrdfTerms evaluateTerms(const Preset& preset, const ShadingPoint& point);

/// BRDF in 1/sr per colour channel: evaluateTerms(...).brdf. What multiplies the light is
/// evaluateTerms(...).response().
dvec3 evaluateBrdf(const Preset& preset, const ShadingPoint& point);

/// Throws that Error. Called by everything that builds the whole BRDF from a preset.
void requireWholeBrdf(const Preset& preset);

} // namespace torrance::brdf
