#include "brdf/distribution.h"

#include "math/quadrature.h"
#include "points.h"
#include "shaders/shared/constants.h"

#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

ShadingPoint halfVectorAt(double tangent, double roughness)
{
    ShadingPoint point = makeShadingPoint(dvec3(0, 0, 1), dvec3(0, 0, 1), dvec3(0, 0, 1), roughness);
    point.NoH = 1.0 / std::sqrt(1.0 + tangent * tangent);
    point.sin2H = tangent * tangent / (1.0 + tangent * tangent);
    point.ToH = tangent * point.NoH;
    point.BoH = 0.0;
    return point;
}

// Integral of D NoH over the hemisphere. With tan = scale x / (1 - x) the highlight spans the same share of [0, 1] at
// every roughness.
double projectedArea(const Method& method, double roughness)
{
    static const QuadratureRule rule = gaussLegendre(256, 0.0, 1.0);
    const double scale = std::max(roughness * roughness, kMinAlpha);
    return integrate(rule, [&](double x) {
        const double tangent = scale * x / (1.0 - x);
        const ShadingPoint point = halfVectorAt(tangent, roughness);
        // dw = 2 pi sin dtheta, dtheta = cos^2 dtan
        const double measure =
            2.0 * kPi * std::sqrt(point.sin2H) * point.NoH * point.NoH * scale / ((1.0 - x) * (1.0 - x));
        return valueOf(method, point).r * point.NoH * measure;
    });
}

TEST(Distribution, IntegratesToOneOverTheProjectedHemisphere)
{
    for (const Method& method : allMethods()) {
        if (method.slot != Slot::distribution)
            continue;
        for (const double roughness : {0.1, 0.2, 0.35, 0.5, 0.7, 0.9, 1.0})
            EXPECT_NEAR(projectedArea(method, roughness), 1.0, 1e-9) << method.id << ' ' << roughness;
    }
}

// The same for one alpha along the tangent and another across it, over slopes: D NoH dw = D NoH^4 d(slope T) d(slope
// B), in polar coordinates of the slopes divided by the alphas.
TEST(Distribution, AnisotropicGgxIntegratesToOneToo)
{
    const QuadratureRule radial = gaussLegendre(200, 0.0, 1.0), around = gaussLegendre(64, 0.0, kPi / 2);
    for (const double roughness : {0.1, 0.5, 0.9})
        for (const double strength : {0.0, 0.3, 1.0}) {
            ShadingPoint point = halfVectorAt(0.0, roughness);
            setAnisotropy(point, dvec3(0, 1, 0), strength);
            const double area = 4.0 * integrate(around, [&](double phi) {
                                    return integrate(radial, [&](double x) {
                                        const double q = x / (1.0 - x);
                                        const double slopeT = point.alphaT * q * std::cos(phi),
                                                     slopeB = point.alphaB * q * std::sin(phi);
                                        point.NoH = 1.0 / std::sqrt(1.0 + slopeT * slopeT + slopeB * slopeB);
                                        point.ToH = slopeT * point.NoH;
                                        point.BoH = slopeB * point.NoH;
                                        return D_ggx_aniso(point) * std::pow(point.NoH, 4) * point.alphaT *
                                               point.alphaB * q / ((1.0 - x) * (1.0 - x));
                                    });
                                });
            EXPECT_NEAR(area, 1.0, 1e-9) << roughness << ' ' << strength;
        }
}

// The second form: the slopes' density of an isotropic surface, stretched (Heitz 2014, section 5.3): D = P(s) / NoH^4.
TEST(Distribution, AnisotropicGgxIsTheStretchedIsotropicOne)
{
    for (ShadingPoint point : gridOfPoints()) {
        setAnisotropy(point, dvec3(0.8, 0.6, 0.0), 0.7);
        const double slopeT = point.ToH / point.NoH / point.alphaT, slopeB = point.BoH / point.NoH / point.alphaB;
        const double stretched = 1.0 / (kPi * std::pow(1.0 + slopeT * slopeT + slopeB * slopeB, 2));
        const double expected = stretched / (point.alphaT * point.alphaB * std::pow(point.NoH, 4));
        EXPECT_NEAR(D_ggx_aniso(point) / expected, 1.0, 1e-12) << point.NoV << ' ' << point.NoL;
    }
}

TEST(Distribution, StrengthZeroIsIsotropicOnAnyTangent)
{
    for (ShadingPoint point : gridOfPoints())
        for (const dvec3& tangent : {dvec3(1, 0, 0), dvec3(-0.3, 0.9, 5.0)}) {
            setAnisotropy(point, tangent, 0.0);
            EXPECT_EQ(point.alphaT, point.alpha);
            EXPECT_NEAR(D_ggx_aniso(point) / D_ggx(point), 1.0, 1e-9)
                << "ToH^2 + BoH^2 rounds as a sum, sin2H does not";
        }
}

// KHR_materials_anisotropy: alpha_t = mix(alpha, 1, strength^2).
TEST(Distribution, StrengthOneIsAFullyRoughTangent)
{
    ShadingPoint point = pointAt(0.5, 0.7, 1.0, 0.4);
    setAnisotropy(point, dvec3(0.5, 0, 2), 1.0);
    EXPECT_EQ(point.alphaT, 1.0);
    EXPECT_EQ(point.alphaB, point.alpha);
    EXPECT_NEAR(glm::length(point.tangent - dvec3(1, 0, 0)), 0.0, 1e-15) << "what lies in the surface";
    EXPECT_NEAR(point.ToH * point.ToH + point.BoH * point.BoH, point.sin2H, 1e-15);
}

TEST(Distribution, PeaksAreOneOverPiAlphaSquared)
{
    for (const Method& method : allMethods())
        if (method.slot == Slot::distribution)
            for (const double roughness : {0.0, 0.01, 0.05, 0.2, 0.6, 1.0}) {
                const ShadingPoint peak = halfVectorAt(0.0, roughness);
                EXPECT_NEAR(valueOf(method, peak).r * kPi * peak.alpha * peak.alpha, 1.0, 1e-7)
                    << method.id << ' ' << roughness;
            }
}

TEST(Distribution, RoughnessZeroIsAFiniteHighlightOfTheLeastAlpha)
{
    EXPECT_EQ(halfVectorAt(0.0, 0.0).alpha, kMinAlpha);
    EXPECT_EQ(halfVectorAt(0.0, 0.0099).alpha, kMinAlpha) << "roughness below 0.01 is altered";
    EXPECT_EQ(halfVectorAt(0.0, 0.01).alpha, 0.01 * 0.01);
    EXPECT_GT(halfVectorAt(0.0, 0.0101).alpha, kMinAlpha) << "and none above";
    EXPECT_EQ(static_cast<float>(kMinAlpha), shared::kMinAlpha);
    EXPECT_EQ(static_cast<float>(kLeastDenominator), shared::kLeastDenominator);
}

// The second form: the formula of the paper as it is printed, in 64-bit-mantissa arithmetic from the tangent.
long double ggxOfThePaper(long double tangent, long double alpha)
{
    const long double cos2 = 1 / (1 + tangent * tangent);
    const long double term = alpha * alpha + tangent * tangent;
    return alpha * alpha / (3.14159265358979323846264338328L * cos2 * cos2 * term * term);
}

TEST(Distribution, GgxIsWaltersEquation33)
{
    for (const double roughness : {0.01, 0.1, 0.4, 1.0})
        for (double tangent = 1e-9; tangent < 1e6; tangent *= 7) {
            const ShadingPoint point = halfVectorAt(tangent, roughness);
            EXPECT_NEAR(D_ggx(point) / static_cast<double>(ggxOfThePaper(tangent, point.alpha)), 1.0, 4e-15)
                << roughness << ' ' << tangent;
        }
}

// Beckmann's exponent and Blinn's power meet as alpha goes to 0 at a fixed tan/alpha: log cos^p = -p/2 tan^2 + O(tan^4
// p).
TEST(Distribution, BlinnGoesToBeckmannForSmoothSurfaces)
{
    for (const double slope : {0.0, 0.5, 1.0, 2.0}) {
        const ShadingPoint point = halfVectorAt(slope * kMinAlpha, 0.01);
        EXPECT_NEAR(D_blinn(point) / D_beckmann(point), 1.0, 1e-6) << slope;
    }
}

TEST(Distribution, UnderflowsToZeroAndNeverToNan)
{
    for (const double roughness : {0.0, 0.01, 0.1, 0.5, 1.0}) {
        ShadingPoint horizon = halfVectorAt(0.0, roughness);
        horizon.NoH = 0;
        horizon.sin2H = 1;
        EXPECT_EQ(D_beckmann(horizon), 0.0);
        EXPECT_EQ(D_blinn(horizon), roughness == 1 ? 1.0 / kPi : 0.0) << "Blinn of alpha 1 is constant";
        EXPECT_NEAR(D_ggx(horizon), horizon.alpha * horizon.alpha / kPi, 1e-15);
    }
}

// What the cross product is for (STYLE.md calls it the form that only spends the inputs' own rounding): 1 - NoH^2 is
// left with few digits.
TEST(Distribution, HalfVectorKeepsItsSineNearTheMirrorDirection)
{
    const double tilt = 1e-7; // v and l off the mirror pair by this: sin h = tilt / (2 cos) to first order
    const ShadingPoint point = makeShadingPoint(dvec3(0, 0, 1), dvec3(0.6, 0, 0.8), dvec3(-0.6, tilt, 0.8), 0.1);
    EXPECT_NEAR(std::sqrt(point.sin2H) / (tilt / 1.6), 1.0, 1e-12);
    EXPECT_GT(std::abs(std::sqrt(std::max(0.0, 1.0 - point.NoH * point.NoH)) / (tilt / 1.6) - 1.0), 1e-6)
        << "if this holds to many digits too, the cross product has become needless";
}

} // namespace
} // namespace torrance::brdf
