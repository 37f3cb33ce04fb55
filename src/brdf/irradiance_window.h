// Harmonics of irradiance that do not swing below zero.
#pragma once

#include "math/vector.h"

#include <array>

namespace torrance::brdf {

/// Band l of nine coefficients (in shBasis's order) times 1 / (1 + lambda l^2 (l + 1)^2), which weighs bands by the
/// square of their Laplacian: Sloan 2008, Stupid SH Tricks, "Windowing". lambda is the least from 0 on with which no
/// channel is below zero in any of some thousand directions; an environment that never was stays as it is.
std::array<dvec3, 9> windowedHarmonics(const std::array<dvec3, 9>& harmonics);

} // namespace torrance::brdf
