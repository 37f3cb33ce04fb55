#include "brdf/visibility.h"

#include "brdf/distribution.h"
#include "math/quadrature.h"
#include "points.h"

#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

std::vector<const Method*> visibilities()
{
    std::vector<const Method*> found;
    for (const Method& method : allMethods())
        if (method.slot == Slot::visibility)
            found.push_back(&method);
    return found;
}

TEST(Visibility, IsFinitePositiveAndReciprocalAboveTheSurface)
{
    for (const Method* method : visibilities())
        for (const ShadingPoint& point : gridOfPoints()) {
            const double value = valueOf(*method, point).r;
            EXPECT_TRUE(std::isfinite(value) && value > 0) << method->id << ' ' << point.NoV << ' ' << point.NoL;
            ShadingPoint swapped = point;
            std::swap(swapped.NoV, swapped.NoL);
            EXPECT_NEAR(valueOf(*method, swapped).r / value, 1.0, 1e-14) << method->id;
        }
}

TEST(Visibility, IsZeroAtAndBelowTheHorizon)
{
    for (const Method* method : visibilities())
        for (const auto& [NoV, NoL] : {std::pair(0.0, 0.5), std::pair(-0.3, 0.5), std::pair(0.5, -1e-9),
                                       std::pair(0.0, 0.0), std::pair(-1.0, -1.0)})
        {
            ShadingPoint point;
            point.NoV = NoV;
            point.NoL = NoL;
            EXPECT_EQ(valueOf(*method, point).r, 0.0) << method->id << ' ' << NoV << ' ' << NoL;
        }
}

// V is not bounded by 1: at grazing it grows as 1 / cos, and stays finite where both cosines are as small as doubles
// get.
TEST(Visibility, IsFiniteWhereBothCosinesVanish)
{
    for (const Method* method : visibilities())
        for (const double cosine : {1e-300, 1e-40, 1e-20, 1e-6}) {
            ShadingPoint point = pointAt(0.5, 0.5, kPi, 0.0);
            point.NoV = cosine;
            point.NoL = cosine;
            point.VoH = cosine;
            const double value = valueOf(*method, point).r;
            EXPECT_TRUE(std::isfinite(value)) << method->id << ' ' << cosine;
            EXPECT_LE(value, 1.0 / kLeastDenominator) << method->id;
        }
    EXPECT_GT(V_smith_corr(pointAt(0.01, 0.01, 0.0, 0.1)), 1.0) << "a clamp to 1 would take real energy";
}

// The guard stands beside what it alters: below V = 1e22 by less than 1e-7.
TEST(Visibility, GuardAltersNothingThatIsSeen)
{
    const ShadingPoint point = pointAt(1e-8, 1e-8, 0.0, 0.01);
    const double unguarded =
        0.5 / (2.0 * point.NoL *
               std::sqrt(point.alpha * point.alpha + (1.0 - point.alpha * point.alpha) * point.NoV * point.NoV));
    EXPECT_NEAR(V_smith_corr(point) / unguarded, 1.0, 1e-7);
}

// The second form, from the definition of Lambda and of G rather than of V: Heitz 2014, eqs. 72, 98 and 99.
long double lambdaOf(long double cosine, long double alpha)
{
    const long double tan2 = (1 - cosine) * (1 + cosine) / (cosine * cosine);
    return (std::sqrt(1 + alpha * alpha * tan2) - 1) / 2;
}

TEST(Visibility, SmithIsHeitzsLambda)
{
    for (const ShadingPoint& point : gridOfPoints()) {
        const long double view = lambdaOf(point.NoV, point.alpha);
        const long double light = lambdaOf(point.NoL, point.alpha);
        const long double four = 4 * static_cast<long double>(point.NoV) * point.NoL;
        const auto correlated = static_cast<double>(1 / (1 + view + light) / four);
        const auto separable = static_cast<double>(1 / ((1 + view) * (1 + light)) / four);
        EXPECT_NEAR(V_smith_corr(point) / correlated, 1.0, 1e-13)
            << point.NoV << ' ' << point.NoL << ' ' << point.alpha;
        EXPECT_NEAR(V_smith_uncorr(point) / separable, 1.0, 1e-13)
            << point.NoV << ' ' << point.NoL << ' ' << point.alpha;
    }
}

// The visible microfacets fill exactly the area that the surface shows: integral of G1(v) max(0, v.h) D(h) dh = n.v
// (Heitz 2014, eq. 16), with G1 = 1 / (1 + Lambda) as V_smith_uncorr holds it: G1(v) = V(v, l = n) 4 NoV, for G1(n)
// = 1.
TEST(Visibility, GgxMaskingMakesVisibleNormalsFillTheProjectedArea)
{
    const QuadratureRule radial = gaussLegendre(200, 0.0, 1.0);
    const QuadratureRule around = gaussLegendre(200, 0.0, kPi); // half of the symmetric circle
    for (const double roughness : {0.3, 0.6, 1.0})
        for (const double NoV : {0.15, 0.5, 0.9}) {
            ShadingPoint point = pointAt(NoV, 1.0, 0.0, roughness);
            const double G1 = V_smith_uncorr(point) * 4.0 * NoV;
            const dvec3 v = directionAt(NoV, 0.0);
            const double area = integrate(radial, [&](double x) {
                const double tangent = point.alpha * x / (1.0 - x);
                point.NoH = 1.0 / std::sqrt(1.0 + tangent * tangent);
                point.sin2H = tangent * tangent * point.NoH * point.NoH;
                const double measure =
                    tangent * point.NoH * point.NoH * point.NoH * point.alpha / ((1.0 - x) * (1.0 - x));
                const double D = D_ggx(point);
                return measure * D * 2.0 * integrate(around, [&](double phi) {
                           return std::max(0.0, glm::dot(v, directionAt(point.NoH, phi)));
                       });
            });
            // The kink of max() limits the rule to about the square of its spacing.
            EXPECT_NEAR(G1 * area, NoV, 1e-4) << roughness << ' ' << NoV;
        }
}

TEST(Visibility, ApproximationsAreExactWhereTheyClaimToBe)
{
    // Head-on nothing is masked: G = 1, V = 1/4.
    for (const Method* method : visibilities())
        EXPECT_NEAR(valueOf(*method, pointAt(1.0, 1.0, 0.0, 0.6)).r, 0.25, 1e-15) << method->id;
    // alpha = 0 and alpha = 1 are the ends of Hammon's blend; there smith_corr is 1/(4 NoV NoL) and 1/(2 (NoV + NoL)).
    for (const ShadingPoint& point : gridOfPoints())
        if (point.perceptualRoughness == 1.0) {
            EXPECT_NEAR(V_hammon(point) / V_smith_corr(point), 1.0, 1e-14);
        }
    // Schlick's k = alpha / 2 meets G1 of Smith at alpha = 1 and normal view only; both ends are 1 for a mirror.
    const ShadingPoint mirror = pointAt(0.4, 0.7, 1.0, 0.0);
    EXPECT_NEAR(V_schlick_half(mirror) / V_smith_uncorr(mirror), 1.0, 1e-3);
}

// G of V-cavities as printed (Cook & Torrance 1982): the least of three, over 4 NoV NoL.
TEST(Visibility, VCavityIsTheLeastOfThree)
{
    for (const ShadingPoint& point : gridOfPoints()) {
        const double G = std::min({1.0, 2 * point.NoH * point.NoV / point.VoH, 2 * point.NoH * point.NoL / point.VoH});
        EXPECT_NEAR(V_vcavity(point) * 4 * point.NoV * point.NoL / G, 1.0, 1e-13);
    }
}

} // namespace
} // namespace torrance::brdf
