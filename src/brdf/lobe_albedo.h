// What multiple scattering and the weight of the body read of the lobe of D ggx and V smith_corr.
#pragma once

#include "brdf/albedo.h"
#include "brdf/shading_point.h"

namespace torrance::brdf {

/// ggxAlbedo. The last two are kept, per thread: whoever integrates over l asks for that of the view each time.
AlbedoTerms lobeTerms(double NoV, double perceptualRoughness);

/// The mean of E over the hemisphere, weighted by the cosine: within 1e-7. The last one is kept, per thread.
double averageLobeAlbedo(double perceptualRoughness);

/// Sets E, bias, ELight and EAverage from NoV, NoL (held within [0, 1]) and perceptualRoughness.
void setLobeAlbedo(ShadingPoint& point);

/// Sets them, and all that the slots diffuse_weight and multiple_scattering read of the other terms, to those of the
/// preset gltf for the point's f0: for looking at one method by itself.
void setInterface(ShadingPoint& point);

} // namespace torrance::brdf
