// Light of an environment under Phong's lobes, as source E keeps it: eight levels of one panorama.
#pragma once

#include "brdf/light_query.h"

namespace torrance::brdf {

inline constexpr int kPhongLevels = 8;

/// Exponent s of level 1 to 7: the level i holds rough = i / 7, and rough = sqrt(sqrt(2 / (s + 2))). 0 of the last:
/// the mean of the hemisphere. Level 0 is the environment itself.
double phongLevelExponent(int level);

/// Where a surface looks the light up: rough * 7, rough being its perceptual roughness of 0.01 or more.
double phongLevel(double perceptualRoughness);

/// The light of the mirror direction, the mean of its two nearest levels: level i the mean of the radiance under
/// (s + 1) / (2 pi) cos^s about it, by quadrature.
dvec3 phongRadiance(const EnvironmentQuery& query);

/// That light times Schlick's F at n.v: h = n. NoV >= 0.
dvec3 Es_phong_levels(const EnvironmentQuery& query);

} // namespace torrance::brdf
