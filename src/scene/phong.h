// Phong's parameters and the microfacet model's, both ways.
#pragma once

namespace torrance {

/// The perceptual roughness whose lobe is that of a Blinn-Phong highlight (n.h)^s: Walter et al. 2007, section 5.2,
/// gives the exponent of the Phong distribution as s = 2 / alpha^2 - 2 for a Beckmann distribution of the same width;
/// alpha = r^2. s >= 0 gives r in (0, 1]; a negative s counts as 0.
double perceptualRoughnessOfShininess(double shininess);

/// Its inverse. r in (0, 1]; infinite at 0.
double shininessOfPerceptualRoughness(double perceptualRoughness);

/// Reflectance at normal incidence of a surface of this index of refraction (against air), and its inverse: the larger
/// of the two indices, 1 or more. Reflectance in [0, 1).
double reflectanceOfIor(double ior);
double iorOfReflectance(double reflectance);

} // namespace torrance
