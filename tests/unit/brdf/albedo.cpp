#include "brdf/albedo.h"

#include "brdf/shading_point.h"
#include "math/quadrature.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

constexpr double kTolerance = 2e-7; // what albedo.h promises

TEST(Albedo, OfTheRoughestSurfaceIsTheClosedForm)
{
    // alpha = 1: D = 1 / pi and V = 1 / (2 (NoL + NoV)), so that E = 1 - NoV ln(1 + 1 / NoV); 1 - ln 2 head on.
    EXPECT_NEAR(ggxAlbedo(1.0, 1.0).albedo(), 1.0 - std::log(2.0), 1e-12);
    for (const double NoV : {1e-5, 1e-3, 0.05, 0.3, 0.8, 0.999})
        EXPECT_NEAR(ggxAlbedo(NoV, 1.0).albedo(), 1.0 - NoV * std::log1p(1.0 / NoV), kTolerance) << "NoV " << NoV;
}

TEST(Albedo, BiasOfTheRoughestSurfaceHeadOnIsTheClosedForm)
{
    // alpha = 1, NoV = 1: the integral of x / (1 + x) (1 - sqrt((1 + x) / 2))^5 over x = NoL in [0, 1].
    const auto f = [](double x) { return x / (1.0 + x) * std::pow(1.0 - std::sqrt(0.5 * (1.0 + x)), 5); };
    EXPECT_NEAR(ggxAlbedo(1.0, 1.0).bias, integrate(gaussLegendre(20, 0.0, 1.0), f), 1e-12);
}

TEST(Albedo, AtGrazingEverythingIsReturned)
{
    // Lambda(v) outgrows Lambda(l): G2 / G1 = 1 for every visible facet as NoV -> 0.
    for (const double r : {0.0, 0.1, 0.5, 1.0})
        EXPECT_NEAR(ggxAlbedo(0.0, r).albedo(), 1.0, kTolerance) << "r " << r;
}

TEST(Albedo, OfAMirrorIsSchlick)
{
    // alpha = 1e-4: VoH = NoV up to the tail of the distribution, of order alpha; the energy loss is of the same order.
    for (const double NoV : {0.3, 0.7, 1.0}) {
        const AlbedoTerms terms = ggxAlbedo(NoV, 0.0);
        EXPECT_NEAR(terms.bias, std::pow(1.0 - NoV, 5), 1e-4);
        EXPECT_NEAR(terms.albedo(), 1.0, 1e-4);
    }
}

/// The same integrals a second way: over half vectors in slopes, D (n . h) taken by its inverse distribution, V and the
/// Jacobian written out from NoL, panel by panel with Gauss-Legendre.
AlbedoTerms albedoOverHalfVectors(double NoV, double r)
{
    const double a = r * r;
    const double sinV = std::sqrt(1.0 - NoV * NoV);
    const QuadratureRule rule = gaussLegendre(24, 0.0, 1.0);
    constexpr int kPanels = 64;
    AlbedoTerms sum;
    for (int i = 0; i < kPanels; ++i)
        for (std::size_t m = 0; m < rule.size(); ++m) {
            const double phi = kPi * (i + rule.nodes[m]) / kPanels;
            const double c = sinV * std::cos(phi);
            const double last = (c + std::sqrt(c * c + NoV * NoV)) / NoV; // the slope at which l lies on the horizon
            // slope = a tan(x), D NoH dOmega = a^2 t / (pi (a^2 + t^2)^2) dt dphi = sin(x) cos(x) / pi dx dphi
            const double lastX = std::atan(last / a);
            for (int j = 0; j < kPanels; ++j)
                for (std::size_t n = 0; n < rule.size(); ++n) {
                    const double x = lastX * (j + rule.nodes[n]) / kPanels;
                    const double t = a * std::tan(x);
                    const double NoH = 1.0 / std::sqrt(1.0 + t * t);
                    const double VoH = (c * t + NoV) * NoH;
                    const double NoL = 2.0 * VoH * NoH - NoV;
                    const double V = 0.5 / (NoL * std::sqrt(a * a + (1 - a * a) * NoV * NoV) +
                                            NoV * std::sqrt(a * a + (1 - a * a) * NoL * NoL));
                    const double measure = rule.weights[m] * rule.weights[n] * kPi * lastX / (kPanels * kPanels);
                    const double light = 2.0 * measure * std::sin(x) * std::cos(x) / kPi * 4.0 * V * NoL * VoH / NoH;
                    const double fresnel = std::pow(1.0 - VoH, 5);
                    sum.scale += light * (1.0 - fresnel);
                    sum.bias += light * fresnel;
                }
        }
    return sum;
}

TEST(Albedo, AgreesWithTheIntegralOverHalfVectors)
{
    for (const double r : {0.15, 0.4, 0.8})
        for (const double NoV : {0.05, 0.6}) {
            const AlbedoTerms a = ggxAlbedo(NoV, r), b = albedoOverHalfVectors(NoV, r);
            EXPECT_NEAR(a.scale, b.scale, kTolerance) << "NoV " << NoV << " r " << r;
            EXPECT_NEAR(a.bias, b.bias, kTolerance) << "NoV " << NoV << " r " << r;
        }
}

TEST(Albedo, DiffuseWeightHeadOnIsOneDimensional)
{
    // NoV = 1: VoH = cos(theta / 2), w = 2 * integral of (1 - sqrt((1 + x) / 2))^5 x over x = NoL.
    const auto f = [](double x) { return 2.0 * x * std::pow(1.0 - std::sqrt(0.5 * (1.0 + x)), 5); };
    EXPECT_NEAR(schlickDiffuseWeight(1.0), integrate(gaussLegendre(20, 0.0, 1.0), f), 1e-10);
}

TEST(Albedo, DiffuseWeightIsTheIntegralOverTheHemisphere)
{
    const QuadratureRule cosines = gaussLegendre(64, 0.0, 1.0), azimuths = gaussLegendre(64, 0.0, kPi);
    for (const double NoV : {0.1, 0.35, 0.8}) {
        const double sum = integrate(cosines, [&](double NoL) {
            return integrate(azimuths, [&](double phi) {
                const double VoL = NoV * NoL + std::sqrt((1 - NoV * NoV) * (1 - NoL * NoL)) * std::cos(phi);
                return 2.0 / kPi * NoL * std::pow(1.0 - std::sqrt(0.5 * (1.0 + VoL)), 5);
            });
        });
        EXPECT_NEAR(schlickDiffuseWeight(NoV), sum, 1e-8)
            << "NoV " << NoV; // the product rule meets sqrt(1 - NoL^2) at NoL = 1
    }
}

} // namespace
} // namespace torrance::brdf
