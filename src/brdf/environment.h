// Light of environments: the rows of slots environmentDiffuse and environmentSpecular, in double.
#pragma once

#include "brdf/light_query.h"
#include "brdf/method.h"

namespace torrance::brdf {

/// Irradiance / pi at n: Lambert's integral by quadrature, which the irradiance cube holds and the method `sampled`
/// sums.
dvec3 Ed_irradiance_cube(const EnvironmentQuery& query);
dvec3 Ed_sampled(const EnvironmentQuery& query);
/// The same from harmonics of the radiance, which never give less than 0.
dvec3 Ed_sh4(const EnvironmentQuery& query);
/// Their first alone: the mean radiance, the same for all directions.
dvec3 Ed_even(const EnvironmentQuery& query);
dvec3 Ed_sh9(const EnvironmentQuery& query);
dvec3 Ed_sh9_windowed(const EnvironmentQuery& query);

/// What GGX with smith_corr and Schlick's term reflects, light that met one microfacet. NoV > 0.
dvec3 Es_even(const EnvironmentQuery& query);
dvec3 Es_split_sum(const EnvironmentQuery& query);
dvec3 Es_split_sum_dominant(const EnvironmentQuery& query);
/// Sums over query.samples directions; radiance is taken in the directions themselves, where the device filters it.
dvec3 Es_filtered_importance(const EnvironmentQuery& query);
dvec3 Es_vndf(const EnvironmentQuery& query);
dvec3 Es_vndf_caps(const EnvironmentQuery& query);
dvec3 Es_vndf_bounded(const EnvironmentQuery& query);
/// The same, and points for the lamps: what both find of these counts by the power heuristic.
dvec3 Es_vndf_lamps(const EnvironmentQuery& query);

/// What source B's phong sees in the mirror direction: the environment itself.
dvec3 Es_mirror(const EnvironmentQuery& query);

/// v mirrored at n.
dvec3 mirrorDirection(const EnvironmentQuery& query);

/// The mean of the radiance under D(h) NoL about `direction`, N = V = R: what a prefiltered level of this alpha holds.
dvec3 ggxMean(const EnvironmentQuery& query, const dvec3& direction, double alpha);

/// Points that vndf_lamps has for an environment's lamps beside so many directions: four for each, for they cost about
/// that much less, and no fewer than tell windows apart.
int lampPointCount(int samples);
inline constexpr int kLeastLampPoints = 64;
inline constexpr int kMostLampPoints = 512; // behind the scene's lights, in one uniform block

/// A method of the slot environmentSpecular that has such points.
bool hasLampPoints(const Method& environmentSpecular);

/// A method of the slot environmentSpecular that draws samples per pixel.
bool drawsSamples(const Method& environmentSpecular);

} // namespace torrance::brdf
