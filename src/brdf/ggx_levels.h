// Light of an environment under GGX's lobes, as source B keeps it: five prefiltered levels above the environment
// itself.
#pragma once

#include "brdf/light_query.h"

namespace torrance::brdf {

inline constexpr int kGgxLevels = 6; // level 0, the environment, among them

/// alpha = r^2 of a level, r = level / 5: lod = 5 r then reads the lobe of each surface's own roughness.
double ggxLevelAlpha(int level);

/// lod = 5 r, r being 0.01 or more; at most `lastLevel`.
double ggxLevel(double perceptualRoughness, int lastLevel = kGgxLevels - 1);

/// The light of the mirror direction, the mean of its two nearest levels: each by quadrature under D(h) n.l of n = v =
/// r (Karis 2013, "Pre-Filtered Environment Map").
dvec3 ggxLevelRadiance(const EnvironmentQuery& query, int lastLevel = kGgxLevels - 1);

/// L (f0 x + y), x and y out of integration_map.h. NoV >= 0.
dvec3 Es_ggx_levels(const EnvironmentQuery& query);

} // namespace torrance::brdf
