#include "brdf/fresnel.h"

#include "points.h"

#include <complex>
#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

void setCosine(ShadingPoint& point, double VoH)
{
    point.VoH = VoH;
    point.oneLessVoH = 1 - VoH;
}

double dielectricAt(double cosine, double ior)
{
    ShadingPoint point;
    setCosine(point, cosine);
    point.ior = ior;
    return F_exact_dielectric(point).g;
}

double conductorAt(double cosine, double eta, double k)
{
    ShadingPoint point;
    setCosine(point, cosine);
    point.eta = dvec3(eta);
    point.k = dvec3(k);
    return F_exact_conductor(point).g;
}

double lazanyiAt(double cosine, double eta, double k)
{
    ShadingPoint point;
    setCosine(point, cosine);
    point.eta = dvec3(eta);
    point.k = dvec3(k);
    return F_lazanyi(point).g;
}

// The second form: Fresnel's amplitudes with their differences left as they are, in a 64-bit mantissa.
double amplitudes(double cosine, double eta, double k)
{
    using Complex = std::complex<long double>;
    const Complex n(eta, k);
    const long double c = cosine;
    const Complex cosT = std::sqrt(Complex(1) - (1 - c * c) / (n * n));
    const Complex s = (c - n * cosT) / (c + n * cosT);
    const Complex p = (n * c - cosT) / (n * c + cosT);
    return static_cast<double>((std::norm(s) + std::norm(p)) / 2);
}

TEST(Fresnel, DielectricIsTheMeanOfBothPolarisations)
{
    for (const double ior : {0.4, 0.75, 0.99, 1.01, 1.33, 1.5, 2.4, 10.0})
        for (const double cosine : {1e-6, 0.01, 0.2, 0.5, 0.67, 0.8, 0.95, 1.0}) {
            const double expected = amplitudes(cosine, ior, 0.0);
            EXPECT_NEAR(dielectricAt(cosine, ior) / expected, 1.0, 1e-12) << ior << ' ' << cosine;
        }
}

TEST(Fresnel, ConductorIsTheMeanOfBothPolarisations)
{
    for (const double eta : {0.05, 0.2, 0.9, 1.0, 1.5, 3.0})
        for (const double k : {0.01, 0.5, 1.9, 3.9, 7.3})
            for (const double cosine : {1e-6, 0.01, 0.2, 0.5, 0.8, 0.95, 1.0})
                EXPECT_NEAR(conductorAt(cosine, eta, k) / amplitudes(cosine, eta, k), 1.0, 1e-12)
                    << eta << ' ' << k << ' ' << cosine;
}

TEST(Fresnel, ConductorWithoutAbsorptionIsADielectric)
{
    for (const double index : {0.4, 0.75, 1.0, 1.2, 1.5, 2.4})
        for (const double cosine : {0.0, 0.01, 0.3, 0.6, 0.9, 1.0})
            EXPECT_NEAR(conductorAt(cosine, index, 0.0), dielectricAt(cosine, index), 1e-14) << index << ' ' << cosine;
}

TEST(Fresnel, NormalReflectanceIsTheSquareOfTheIndexRatio)
{
    for (const double ior : {0.5, 1.33, 1.5, 2.0, 3.0})
        EXPECT_NEAR(dielectricAt(1.0, ior), std::pow((ior - 1) / (ior + 1), 2), 1e-15);
    EXPECT_NEAR(dielectricAt(1.0, 1.5), 0.04, 1e-16) << "the reflectance that glTF takes for index 1.5";
}

TEST(Fresnel, IndexOneReflectsExactlyNothing)
{
    for (const double cosine : {0.0, 1e-12, 1e-3, 0.5, 1.0}) {
        EXPECT_EQ(dielectricAt(cosine, 1.0), 0.0);
        EXPECT_EQ(conductorAt(cosine, 1.0, 0.0), 0.0);
        EXPECT_EQ(lazanyiAt(cosine, 1.0, 0.0), 0.0);
    }
    ShadingPoint grazing;
    setCosine(grazing, 0);
    grazing.f0 = dvec3(0);
    EXPECT_EQ(F_schlick(grazing), dvec3(1)) << "Schlick's term still rises to one, as it is written";
}

// To first order in n - 1, F(cos) = ((n - 1) / 2)^2 (1 + tan^4) / cos^... : both amplitudes are (n - 1)/2 sec^2 and (n
// - 1)/2 (1 - tan^2).
TEST(Fresnel, VanishesAsTheSquareOfTheIndexStep)
{
    const double step = 1e-6;
    for (const double cosine : {0.3, 0.6, 1.0}) {
        const double sec2 = 1 / (cosine * cosine);
        const double expected = step * step / 8 * (sec2 * sec2 + (2 - sec2) * (2 - sec2));
        EXPECT_NEAR(dielectricAt(cosine, 1 + step) / expected, 1.0, 4e-5) << cosine;
    }
}

TEST(Fresnel, IndexZeroMeansInfinite)
{
    for (const double cosine : {0.0, 0.3, 1.0})
        EXPECT_EQ(dielectricAt(cosine, 0.0), 1.0);
    EXPECT_NEAR(dielectricAt(0.5, 1e6), 1.0, 1e-5) << "as the limit has it: 1 - 2 (c + 1/c) / n";
}

TEST(Fresnel, ReflectsAllBeyondTheCriticalAngle)
{
    const double ior = 0.75;
    const double critical = std::sqrt(1 - ior * ior); // cosine: sin = n
    EXPECT_EQ(dielectricAt(critical * 0.999, ior), 1.0);
    EXPECT_EQ(dielectricAt(0.0, ior), 1.0);
    EXPECT_LT(dielectricAt(critical * 1.001, ior), 1.0);
    EXPECT_GT(dielectricAt(critical * (1 + 1e-13), ior), 1 - 1e-5) << "continuous there";
}

TEST(Fresnel, ParallelLightVanishesAtBrewstersAngle)
{
    const double ior = 1.5;
    const double cosine = 1 / std::sqrt(1 + ior * ior); // tan = n
    const double perpendicular = std::pow((ior * ior - 1) / (ior * ior + 1), 2);
    EXPECT_NEAR(dielectricAt(cosine, ior), perpendicular / 2, 1e-15);
}

TEST(Fresnel, EverythingIsReflectedAtGrazing)
{
    EXPECT_DOUBLE_EQ(dielectricAt(0.0, 1.5), 1.0);
    EXPECT_NEAR(conductorAt(0.0, 0.2, 3.9), 1.0, 1e-15);
    ShadingPoint point;
    setCosine(point, 0);
    point.f0 = dvec3(0.3, 0.5, 0.7);
    EXPECT_EQ(F_schlick(point), dvec3(1));
    setCosine(point, 1);
    EXPECT_EQ(F_schlick(point), point.f0);
    point.f90 = dvec3(0); // a specular weight of zero takes the grazing term with it
    point.f0 = dvec3(0);
    setCosine(point, 0.1);
    EXPECT_EQ(F_schlick(point), dvec3(0));
}

ShadingPoint pointOf(double cosine, double f0)
{
    ShadingPoint point;
    setCosine(point, cosine);
    point.f0 = dvec3(f0);
    return point;
}

// Karis' exponent is a fit: it meets the fifth power within 5e-3 everywhere, the size of what it was fitted to lose,
// and is exact at grazing. The second form: e to the quadratic.
TEST(Fresnel, SphericalGaussianIsCloseToSchlick)
{
    for (double c = 0.0; c <= 1.0; c += 0.01) {
        const ShadingPoint point = pointOf(c, 0.04);
        const double power = std::exp(-std::log(2.0) * (5.55473 * c * c + 6.98316 * c));
        EXPECT_NEAR(F_sg(point).r, 0.04 + 0.96 * power, 1e-15);
        EXPECT_NEAR(F_sg(point).r, F_schlick(point).r, 5e-3) << c;
    }
    EXPECT_EQ(F_sg(pointOf(0.0, 0.3)), dvec3(1));
}

TEST(Fresnel, WhiteF82IsSchlick)
{
    for (double c = 0.0; c <= 1.0; c += 0.01)
        EXPECT_NEAR(F_f82(pointOf(c, 0.4)).g, F_schlick(pointOf(c, 0.4)).g, 1e-15);
}

// At the cosine 1/7 it is the tint's share of Schlick's term, head-on f0, at grazing 1: what it is made from.
TEST(Fresnel, F82MeetsItsThreeValues)
{
    for (const double f0 : {0.02, 0.5, 0.95})
        for (const double tint : {0.5, 0.8, 1.0}) {
            const auto at = [&](double cosine) {
                ShadingPoint point = pointOf(cosine, f0);
                point.f82 = dvec3(tint);
                return F_f82(point).b;
            };
            EXPECT_NEAR(at(1.0 / 7.0), tint * F_schlick(pointOf(1.0 / 7.0, f0)).b, 1e-15);
            EXPECT_EQ(at(1.0), f0);
            EXPECT_EQ(at(0.0), 1.0);
        }
}

// The stated range of the clamp: nothing is altered for tints of [25/49, 1]. It is smallest at f0 = 0, where F / x^5 =
// 1
// - 49/6 (1 - tint) c x, x = 1 - c, which is least at c = 1/2.
TEST(Fresnel, F82IsHeldWithinZeroAndOneForDarkAndBrightTintsOnly)
{
    const auto unclamped = [](double c, double f0, double tint) {
        const double b = (f0 + (1 - f0) * std::pow(6.0 / 7.0, 5)) * (1 - tint) / (std::pow(6.0 / 7.0, 6) / 7.0);
        return f0 + (1 - f0) * std::pow(1 - c, 5) - b * c * std::pow(1 - c, 6);
    };
    double least = 1, greatest = 0;
    for (double c = 0.0; c <= 1.0; c += 0.005)
        for (double f0 = 0.0; f0 <= 1.0; f0 += 0.05)
            for (double tint = 0.0; tint <= 1.5; tint += 0.05) {
                ShadingPoint point = pointOf(c, f0);
                point.f82 = dvec3(tint);
                const double F = unclamped(c, f0, tint);
                if (tint > 25.0 / 49.0 && tint < 1.001) {
                    EXPECT_NEAR(F_f82(point).r, F, 1e-14) << c << ' ' << f0 << ' ' << tint;
                }
                EXPECT_NEAR(F_f82(point).r, std::clamp(F, 0.0, 1.0), 1e-14) << c << ' ' << f0 << ' ' << tint;
                least = std::min(least, F);
                greatest = std::max(greatest, F);
            }
    EXPECT_LT(least, 0.0) << "if this holds no more, the clamp is needless";
    EXPECT_GT(greatest, 1.0);
}

// What it is for: metals, whose dip before grazing Schlick's term misses (aluminium, copper at 650 nm, iron). It meets
// Fresnel's equations at three cosines by its making.
TEST(Fresnel, LazanyiFollowsMetalsBetterThanSchlick)
{
    for (const auto& [eta, k] : {std::pair(1.5, 7.8), std::pair(0.21, 3.67), std::pair(2.9, 3.1)}) {
        EXPECT_NEAR(lazanyiAt(1.0, eta, k), conductorAt(1.0, eta, k), 1e-14);
        EXPECT_NEAR(lazanyiAt(1.0 / 7.0, eta, k), conductorAt(1.0 / 7.0, eta, k), 1e-14);
        EXPECT_NEAR(lazanyiAt(0.0, eta, k), 1.0, 1e-14);
        double worst = 0, worstOfSchlick = 0;
        for (double c = 0.0; c <= 1.0; c += 0.01) {
            const double exact = conductorAt(c, eta, k);
            worst = std::max(worst, std::abs(lazanyiAt(c, eta, k) - exact));
            worstOfSchlick =
                std::max(worstOfSchlick, std::abs(F_schlick(pointOf(c, conductorAt(1.0, eta, k))).r - exact));
        }
        EXPECT_LT(worst, worstOfSchlick) << eta << ' ' << k;
    }
}

// The second form: the paper's fraction, its term added as it is printed.
TEST(Fresnel, LazanyiIsThePapersFormula)
{
    for (const auto& [eta, k] : {std::pair(1.5, 7.8), std::pair(0.21, 3.67), std::pair(2.9, 3.1)}) {
        const auto fraction = [eta = eta, k = k](long double c) {
            return ((eta - 1) * (eta - 1) + 4 * eta * std::pow(1 - c, 5.0L) + k * k) / ((eta + 1) * (eta + 1) + k * k);
        };
        const long double seventh = 1 / 7.0L;
        const long double a =
            (fraction(seventh) - amplitudes(1.0 / 7.0, eta, k)) / (seventh * std::pow(1 - seventh, 6.0L));
        for (double c = 0.0; c <= 1.0; c += 0.05) {
            const long double F = fraction(c) - a * c * std::pow(1.0L - c, 6.0L);
            EXPECT_NEAR(lazanyiAt(c, eta, k), static_cast<double>(F), 1e-13) << eta << ' ' << c;
        }
    }
}

// Beyond the critical angle F is 1 up to the rounding of u^2, which the grid makes as small as 1e-2 of its terms.
TEST(Fresnel, StaysWithinZeroAndOne)
{
    for (const Method& method : allMethods())
        if (method.slot == Slot::fresnel)
            for (ShadingPoint point : gridOfPoints())
                for (const double eta : {0.05, 0.5, 1.0, 1.5, 4.0})
                    for (const double k : {0.0, 1e-9, 1.0, 9.0}) {
                        point.ior = eta;
                        point.eta = dvec3(eta);
                        point.k = dvec3(k);
                        point.f82 = dvec3(0.2 * k);
                        const double F = valueOf(method, point).b;
                        EXPECT_TRUE(F >= 0 && F <= 1 + 1e-13)
                            << method.id << ' ' << eta << ' ' << k << ' ' << point.VoH;
                    }
}

} // namespace
} // namespace torrance::brdf
