// The BRDF integration map of source B: what the lobe and the body of the model ggx_burley return under even light.
#pragma once

#include "math/vector.h"

namespace torrance::brdf {

/// At (n.v, r) of [0, 1], alpha = max(r^2, kMinAlpha): x and y are the integrals over l of D V n.l (1 - (1 - l.h)^5)
/// and D V n.l (1 - l.h)^5, so that Schlick's lobe of reflectance f0 returns f0 x + y of light of radiance 1; z is that
/// of the diffuse term, of white. V is G / (4 n.l n.v) without the 1e-6 of the model's denominator: n.l n.v of G cancel
/// it, and nothing is divided by zero. x and y within 2e-7, z exact.
dvec3 integrationMap(double NoV, double perceptualRoughness);

} // namespace torrance::brdf
