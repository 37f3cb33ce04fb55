// What a shading formula is given, in double. Vectors are unit and point away from the surface.
#pragma once

#include "math/vector.h"

namespace torrance::brdf {

/// alpha = max(r^2, kMinAlpha): roughness 0 with a point light is a finite highlight of peak 1 / (pi kMinAlpha^2). It
/// alters perceptual roughness below 0.01 only. The same constant stands in shaders/shared/constants.h.
inline constexpr double kMinAlpha = 1e-4;

/// Added to denominators that vanish with both cosines. D <= 1 / (pi kMinAlpha^2) = 3.2e7, so that D V stays
/// below 1.6e37, finite in 32 bits; V below 1e22 is altered by less than 1e-7. The same constant stands in
/// shaders/shared/constants.h.
inline constexpr double kLeastDenominator = 1e-30;

struct ShadingPoint
{
    dvec3 n = dvec3(0, 0, 1), v = dvec3(0, 0, 1), l = dvec3(0, 0, 1);
    dvec3 tangent = dvec3(1, 0, 0); // unit, in the surface; the bitangent is n x tangent

    double NoV = 1, NoL = 1; // signed
    double VoL = 1;
    double NoH = 1, VoH = 1; // h = (v + l) / |v + l|
    double ToH = 0, BoH = 0; // along the tangent, bitangent
    double sin2H = 0;        // 1 - NoH^2 = |n x t|^2 / |t|^2, t = v + l
    double oneLessVoH = 0;   // 1 - VoH = |v - l|^2 / (4 (1 + VoH))

    double perceptualRoughness = 1;
    double anisotropy = 0; // strength, [0, 1]; 0 makes both alphas alpha, whatever the tangent
    double alpha = 1;      // max(r^2, kMinAlpha)
    double alphaT = 1;     // alpha + (1 - alpha) anisotropy^2 (KHR_materials_anisotropy)
    double alphaB = 1;     // alpha

    dvec3 f0 = dvec3(0.04), f90 = dvec3(1.0);
    double ior = 1.5;       // transmitted over incident; 0 means infinite
    dvec3 eta = dvec3(1.5); // complex index of a conductor
    dvec3 k = dvec3(0.0);
    dvec3 f82 = dvec3(1.0); // reflectance at the cosine 1/7 (82 degrees) over Schlick's there; white is Schlick's
    dvec3 baseColor = dvec3(1.0);
    double metallic = 0;

    bool albedosOfTable = false; // E and bias within 1e-6 of the quadrature, which takes a hundred times as long

    // What the other terms tell multiple scattering. E is the directional albedo of the specular lobe with F = 1.
    double E = 1;                    // at NoV
    double bias = 0;                 // of it what Schlick's (1 - VoH)^5 takes (albedo.h)
    double ELight = 1;               // at NoL
    double EAverage = 1;             // its mean over the hemisphere, weighted by the cosine
    dvec3 single = dvec3(1);         // the lobe of light reflected once, D V F
    dvec3 spread = dvec3(1.0 / kPi); // a white Lambertian surface's

    // What the interface over the body reflects.
    dvec3 F = dvec3(0.04), FNoV = dvec3(0.04), FNoL = dvec3(0.04); // Fresnel's term at VoH, NoV and NoL
    dvec3 lobeAlbedo = dvec3(0.04); // of the whole lobe at NoV, multiple scattering included
};

/// Fills the cosines, sin2H, oneLessVoH and the alphas from n, v, l and perceptualRoughness. n, v, l are normalised
/// first. Where l = -v there is no half vector: NoH = 0, sin2H = 1, VoH = 0 (nothing is reflected there: one of NoV,
/// NoL is <= 0). The surface is isotropic, its tangent is any.
ShadingPoint makeShadingPoint(const dvec3& n, const dvec3& v, const dvec3& l, double perceptualRoughness);

/// Turns the point's tangent to what lies in the surface of `tangent` (not along n) and sets ToH, BoH and the alphas
/// for a strength of anisotropy in [0, 1].
void setAnisotropy(ShadingPoint& point, const dvec3& tangent, double anisotropy);

} // namespace torrance::brdf
