// Directional albedo of glTF's specular lobe (D ggx, V smith_corr) by quadrature in double: the truth behind the DFG
// table.
#pragma once

#include <functional>

namespace torrance::brdf {

/// The split sum of Karis 2013: with Schlick's Fresnel term of f90 = 1, the light that a surface of reflectance F0
/// returns under uniform light of radiance 1 is F0 * scale + bias.
struct AlbedoTerms
{
    double scale = 0.0; // integral of D V NoL (1 - (1 - VoH)^5) over l
    double bias = 0.0;  // integral of D V NoL (1 - VoH)^5 over l

    double albedo() const { return scale + bias; } // F0 = 1: E of the energy compensation
};

/// NoV in [0, 1] (0: the limit), perceptual roughness in [0, 1]; alpha = max(r^2, kMinAlpha). Both terms are within
/// 2e-7 of the exact ones (tests/unit/brdf/albedo.cpp).
AlbedoTerms ggxAlbedo(double NoV, double perceptualRoughness);

/// The same of D ggx with another V that depends on the cosines alone: V at NoL for this NoV, finite and smooth.
AlbedoTerms ggxAlbedo(double NoV, double perceptualRoughness, const std::function<double(double NoL)>& visibility);

/// w = 1/pi * integral of (1 - VoH)^5 NoL over l, h halfway between v and l: what Schlick's term takes from glTF's
/// diffuse (1 - F(VoH)) / pi under uniform light, which returns (1 - F0) (1 - w). NoV in [0, 1]; within 1e-10.
double schlickDiffuseWeight(double NoV);

} // namespace torrance::brdf
