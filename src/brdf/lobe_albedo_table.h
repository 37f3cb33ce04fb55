// The albedo of the lobe of D ggx and V smith_corr for whoever needs it at every direction of light: the quadrature of
// lobe_albedo.h takes a hundred times as long as all else that a direction costs.
#pragma once

#include "brdf/albedo.h"

namespace torrance::brdf {

/// E at NoV in [0, 1] and the perceptual roughness in [0, 1]: that of lobeTerms within 1e-6 of it, for cosines from
/// 1e-4 on; below within 1e-5. Interpolated between nodes that are computed when they are first asked for: the value
/// depends on the arguments alone, and any number of threads may ask.
double lobeAlbedoFromTable(double NoV, double perceptualRoughness);

/// lobeTerms with E of lobeAlbedoFromTable and the bias as near to its own: for whoever asks of a point a few
/// times. The last ones are kept, per thread.
AlbedoTerms lobeTermsFromTable(double NoV, double perceptualRoughness);

/// averageLobeAlbedo within 1e-6 of it, in the same manner.
double averageLobeAlbedoFromTable(double perceptualRoughness);

} // namespace torrance::brdf
