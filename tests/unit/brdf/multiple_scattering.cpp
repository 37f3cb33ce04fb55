#include "brdf/multiple_scattering.h"

#include "brdf/brdf.h"
#include "brdf/lobe_albedo.h"
#include "math/quadrature.h"
#include "points.h"

#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

// alpha = 1: E = 1 - c ln(1 + 1/c), so that the mean of 1 - E is 2 integral of c^2 ln(1 + 1/c) = 2/3 (2 ln 2 - 1/2).
TEST(LobeAlbedo, MeanOfTheRoughestSurfaceIsTheClosedForm)
{
    EXPECT_NEAR(1.0 - averageLobeAlbedo(1.0), 2.0 / 3.0 * (2.0 * std::log(2.0) - 0.5), 1e-9);
}

// The second form: panels over the cosine itself.
TEST(LobeAlbedo, MeanIsTheIntegralOverCosines)
{
    for (const double r : {0.1, 0.3, 0.6, 0.9}) {
        double mean = 0;
        constexpr int kPanels = 8;
        for (int i = 0; i < kPanels; ++i) {
            const double low = std::pow(0.25, kPanels - i), high = std::pow(0.25, kPanels - i - 1);
            mean += integrate(gaussLegendre(10, i == 0 ? 0.0 : low, high),
                              [&](double c) { return 2.0 * c * ggxAlbedo(c, r).albedo(); });
        }
        EXPECT_NEAR(averageLobeAlbedo(r), mean, 1e-6) << r;
    }
}

TEST(LobeAlbedo, KeepsWhatBelongsToItsArguments)
{
    for (const double NoV : {0.2, 0.7, 0.2, 0.4, 0.7})
        for (const double r : {0.3, 0.8})
            EXPECT_EQ(lobeTerms(NoV, r).bias, ggxAlbedo(NoV, r).bias);
}

TEST(MultipleScattering, MeanOfSchlicksTermIsItsIntegral)
{
    const double mean =
        integrate(gaussLegendre(8, 0.0, 1.0), [](double c) { return 2.0 * c * (0.3 + 0.7 * std::pow(1.0 - c, 5)); });
    EXPECT_NEAR(averageSchlick(dvec3(0.3)).r, mean, 1e-15);
}

/// The lobe's albedo with multiple scattering: each method is linear in what it is given (multiple_scattering.h).
dvec3 returned(const Method& method, double NoV, double r, const dvec3& f0)
{
    ShadingPoint point = pointAt(NoV, 0.5, 0.0, r);
    setLobeAlbedo(point);
    point.f0 = f0;
    point.single = f0 * (point.E - point.bias) + point.bias;
    point.spread = dvec3(1);
    point.ELight = point.EAverage;
    return valueOf(method, point);
}

std::vector<const Method*> compensations()
{
    std::vector<const Method*> found;
    for (const Method& method : allMethods())
        if (method.slot == Slot::multipleScattering && method.readsAlbedo)
            found.push_back(&method);
    return found;
}

// METHODS.md: any compensation at F0 = 1, furnace returns 1.
TEST(MultipleScattering, WhiteMetalReturnsAllLight)
{
    for (const Method* method : compensations())
        for (const double r : {0.0, 0.1, 0.4, 0.7, 1.0})
            for (const double NoV : {0.01, 0.2, 0.6, 1.0})
                EXPECT_NEAR(returned(*method, NoV, r, dvec3(1)).g, 1.0, 1e-12) << method->id << ' ' << NoV << ' ' << r;
}

// That the averaged arguments give the furnace is what the environment's light rests on: here the integral over l is
// carried out, with E at each l.
TEST(MultipleScattering, FurnaceByQuadratureIsWhatTheAveragedArgumentsGive)
{
    const QuadratureRule roots = gaussLegendre(24, 0.0, 1.0), azimuths = gaussLegendre(24, 0.0, kPi);
    for (const Method* method : compensations()) {
        Preset preset = *findPreset("gltf");
        preset.multipleScattering = method;
        for (const auto& [r, NoV] : {std::pair(0.8, 0.4), std::pair(1.0, 0.9)}) {
            const double sum = integrate(roots, [&, r = r, NoV = NoV](double root) {
                const double NoL = root * root;
                return 2.0 * root * NoL * 2.0 * integrate(azimuths, [&](double phi) {
                           ShadingPoint point = pointAt(NoV, NoL, phi, r);
                           point.metallic = 1;
                           point.baseColor = dvec3(0.6);
                           return evaluateBrdf(preset, point).g;
                       });
            });
            EXPECT_NEAR(sum, returned(*method, NoV, r, dvec3(0.6)).g, 1e-5) << method->id << ' ' << NoV << ' ' << r;
        }
    }
}

// A real surface returns no more than it receives, and more reflections never darken: f0 <= 1, and single <= whole.
TEST(MultipleScattering, AddsLightAndNeverMoreThanWasLost)
{
    for (const Method* method : compensations())
        for (const double r : {0.05, 0.3, 0.6, 1.0})
            for (const double NoV : {0.02, 0.3, 0.8, 1.0})
                for (const double f0 : {0.0, 0.04, 0.5, 0.9, 1.0}) {
                    const AlbedoTerms terms = lobeTerms(NoV, r);
                    const double whole = returned(*method, NoV, r, dvec3(f0)).r;
                    EXPECT_GE(whole, f0 * terms.scale + terms.bias) << method->id;
                    EXPECT_LE(whole, 1.0 + 1e-12) << method->id << ' ' << NoV << ' ' << r << ' ' << f0;
                }
}

// The second form of the sums: bounce by bounce.
TEST(MultipleScattering, ClosedFormsAreTheirSumsOverBounces)
{
    ShadingPoint point = pointAt(0.3, 0.7, 1.0, 0.9);
    setLobeAlbedo(point);
    point.f0 = dvec3(0.2, 0.7, 0.95);
    point.single = dvec3(0);
    for (int c = 0; c < 3; ++c) {
        const double F = point.f0[c] + (1.0 - point.f0[c]) / 21.0;
        // Hill 2018: the k-th reflection leaves with F^k EAverage (1 - EAverage)^(k - 2), k >= 2, of what was lost.
        // Fdez-Aguera 2019: with F_ss E_ss F^k (1 - E)^k, k >= 1.
        double hill = 0, fdez = 0;
        for (int k = 1; k < 2000; ++k) {
            hill += k < 2 ? 0.0 : std::pow(F, k) * point.EAverage * std::pow(1.0 - point.EAverage, k - 2);
            fdez += (point.f0[c] * (point.E - point.bias) + point.bias) * std::pow(F * (1.0 - point.E), k);
        }
        const double shape = (1.0 - point.E) * (1.0 - point.ELight) / (kPi * (1.0 - point.EAverage));
        EXPECT_NEAR(M_kulla_conty(point)[c], hill * shape, 1e-14);
        EXPECT_NEAR(M_fdez_aguera(point)[c], fdez / kPi, 1e-14);
    }
}

TEST(MultipleScattering, AlbedosBeyondOneLoseNothing)
{
    ShadingPoint point = pointAt(0.5, 0.5, 0.0, 0.0);
    point.single = dvec3(0.25);
    point.E = point.ELight = 1.0 + 1e-7;
    point.EAverage = 1.0;
    EXPECT_EQ(M_kulla_conty(point), point.single);
    EXPECT_EQ(M_fdez_aguera(point), point.single);
}

} // namespace
} // namespace torrance::brdf
