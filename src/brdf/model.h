// How the terms are put together: one formula per row of the slot `model`, each with exactly the guards, clamps and
// mappings of its source. Read from a point: n, v, l and what follows from them, perceptualRoughness, baseColor,
// metallic.
#pragma once

#include "brdf/brdf_terms.h"
#include "brdf/shading_point.h"

namespace torrance::brdf {

struct Preset;

/// glTF 2.0, Appendix B, from the preset's methods of the other slots.
BrdfTerms model_gltf(const Preset& preset, const ShadingPoint& point);

// The source systems bring their own D, G, F and diffuse.
BrdfTerms model_ue4_direct(const Preset& preset, const ShadingPoint& point);
BrdfTerms model_phong(const Preset& preset, const ShadingPoint& point);
BrdfTerms model_cook_torrance_beckmann(const Preset& preset, const ShadingPoint& point);
BrdfTerms model_ggx_burley(const Preset& preset, const ShadingPoint& point);
BrdfTerms model_schlick_beckmann(const Preset& preset, const ShadingPoint& point);
BrdfTerms model_smith_r(const Preset& preset, const ShadingPoint& point);
BrdfTerms model_torrance_sparrow_blinn(const Preset& preset, const ShadingPoint& point);

} // namespace torrance::brdf
