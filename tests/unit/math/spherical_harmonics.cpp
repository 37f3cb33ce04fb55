#include "math/spherical_harmonics.h"
#include "math/quadrature.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

/// Exact for polynomials of degree 9 on the sphere: Gauss along z, trapezoid around it.
template <typename Function>
double integrateSphere(const Function& f)
{
    constexpr int kColumns = 12;
    return integrate(gaussLegendre(6, -1.0, 1.0), [&](double z) {
        double sum = 0.0;
        for (int i = 0; i < kColumns; ++i) {
            const double phi = 2.0 * kPi * i / kColumns;
            const double r = std::sqrt(1.0 - z * z);
            sum += f(dvec3(r * std::cos(phi), r * std::sin(phi), z)) * 2.0 * kPi / kColumns;
        }
        return sum;
    });
}

TEST(SphericalHarmonics, AreOrthonormal)
{
    for (std::size_t i = 0; i < kSh9Count; ++i)
        for (std::size_t j = 0; j < kSh9Count; ++j)
            EXPECT_NEAR(integrateSphere([&](const dvec3& d) { return shBasis(d)[i] * shBasis(d)[j]; }),
                        i == j ? 1.0 : 0.0, 1e-13)
                << i << " with " << j;
}

TEST(SphericalHarmonics, HaveThePublishedConstants)
{
    // Ramamoorthi & Hanrahan 2001, eq. 3.
    const Sh9 y = shBasis(glm::normalize(dvec3(1, 2, 3)));
    const double n2 = 14.0;
    EXPECT_NEAR(y[0], 0.282095, 1e-6);
    EXPECT_NEAR(y[3], 0.488603 * 1 / std::sqrt(n2), 1e-6);
    EXPECT_NEAR(y[4], 1.092548 * 2 / n2, 1e-6);
    EXPECT_NEAR(y[6], 0.315392 * (3 * 9 / n2 - 1), 1e-6);
    EXPECT_NEAR(y[8], 0.546274 * (1 - 4) / n2, 1e-6);
}

TEST(SphericalHarmonics, CosineBandsAreTheFunkHeckeIntegrals)
{
    // Band l of a zonal kernel k: 2 pi times the integral of k(z) P_l(z); here over [0, 1] with k = z.
    for (int l = 0; l <= 8; ++l) {
        const double band = integrate(gaussLegendre(12, 0.0, 1.0), [&](double z) {
            return 2.0 * kPi * z * std::legendre(static_cast<unsigned>(l), z);
        });
        EXPECT_NEAR(clampedCosineBand(l), band, 1e-14) << "band " << l;
    }
    EXPECT_NEAR(clampedCosineBand(2), kPi / 4.0, 1e-15);
}

} // namespace
} // namespace torrance
