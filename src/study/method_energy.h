// What a method does with light, from its formula in double: how much of it comes back, and whether it goes both ways.
#pragma once

#include "brdf/method.h"

#include <optional>

namespace torrance {

/// How far quadrature may be above the limit of 1: twice what it misses by where the answer is known
/// (tests/unit/study/method_energy.cpp).
inline constexpr double kEnergySlack = 2e-4;

/// What must not be above 1, at NoV and a perceptual roughness; nothing for slots that promise nothing.
/// D: the area of the facets seen from above, the integral of D NoH. V: the light that comes back from D ggx with F
/// = 1. Diffuse, sheen: that of a white one. Multiple scattering: that of a white metal in the furnace. DFG: scale +
/// bias.
std::optional<double> returnedEnergy(const brdf::Method& method, double NoV, double perceptualRoughness);

/// |f(v, l) - f(l, v)| over the greater of both, at its worst over lights and half vectors; nothing for slots that are
/// no part of f.
std::optional<double> reciprocityError(const brdf::Method& method, double NoV, double perceptualRoughness);

} // namespace torrance
