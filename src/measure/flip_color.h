// The colour spaces and distances of FLIP.
#pragma once

#include "math/vector.h"

namespace torrance::flip {

/// Linear Rec. 709, white at (1, 1, 1), to the opponent space Y Cx Cz of the contrast sensitivity functions (2020, eq.
/// 1).
dvec3 opponentFromLinear(const dvec3& rgb);
dvec3 linearFromOpponent(const dvec3& opponent);

/// CIELAB under D65 with the chroma scaled by the lightness: Hunt's effect (2020, section 4.1.3).
dvec3 huntLab(const dvec3& linear);

/// HyAB: lightness city-block, chroma Euclidean (2020, eq. 2).
double hyab(const dvec3& a, const dvec3& b);

/// HyAB of two Hunt-adjusted colours, compressed and mapped to [0, 1] (2020, section 4.1.4).
double colorDifference(const dvec3& huntLabA, const dvec3& huntLabB);

} // namespace torrance::flip
