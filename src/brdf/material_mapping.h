// Between glTF's material parameters and those of the source systems, both ways: docs/sources.md has the table.
#pragma once

#include "math/vector.h"

namespace torrance::brdf {

/// Exponent s of (n.h)^s, sources B and E: alpha^2 = 2 / (s + 2), which is E's own rough = sqrt(sqrt(2 / (s + 2))). It
/// makes Blinn's peak that of Beckmann and GGX. alpha is at least kMinAlpha, so s at most 2e8.
double shininessOf(double perceptualRoughness);
/// s >= 0; greater than 2e8 gives what 2e8 gives.
double roughnessOfShininess(double shininess);

/// Exponent of (R.v)^g, source B. R turns twice as fast as h, so that near the highlight (R.v)^g = (n.h)^(4 g): g =
/// s/4.
double glossinessOf(double perceptualRoughness);
double roughnessOfGlossiness(double glossiness);

/// R0 of source E, one number for all channels: 0.04 of a dielectric; 1 of a metal, whose colour multiplies the whole
/// lobe there; between them as metallic says.
double r0Of(double metallic);

/// A material of source E with metalness 0 or 1 as glTF has it: a metal's F0 is R0 times its colour.
struct MetallicColor
{
    dvec3 baseColor = dvec3(1.0);
    double metallic = 0.0;
};
/// Source E's (color, metalness, R0) in glTF's terms; r0Of and the colour give it back where R0 = r0Of(metalness).
MetallicColor metallicOfR0(const dvec3& color, double metalness, double r0);

/// ((n1 - n2) / (n1 + n2))^2, from the indices on both sides: source B.
double reflectanceOfIndices(double n1, double n2);

} // namespace torrance::brdf
