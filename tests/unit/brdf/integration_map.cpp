#include "brdf/integration_map.h"

#include "brdf/brdf.h"
#include "math/quadrature.h"
#include "points.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

// alpha = 1 and k = 1/2: D = 1/pi and V = 1 / ((1 + NoV)(1 + NoL)), so that x + y = 2 (1 - ln 2) / (1 + NoV). Of Burley
// head on f90 = 3/2 + NoL: z = 1 + 1/42 + 1/84; at grazing the mean over the azimuth adds alpha^2 (1 - NoL^2) / 2.
TEST(IntegrationMap, OfTheRoughestSurfaceIsTheClosedForm)
{
    for (const double NoV : {0.0, 1e-3, 0.05, 0.3, 0.8, 1.0}) {
        const dvec3 map = integrationMap(NoV, 1.0);
        EXPECT_NEAR(map.x + map.y, 2.0 * (1.0 - std::log(2.0)) / (1.0 + NoV), 2e-7) << "NoV " << NoV;
    }
    EXPECT_NEAR(integrationMap(1.0, 1.0).z, 1.0 + 1.0 / 42 + 1.0 / 84, 1e-14);
    EXPECT_NEAR(integrationMap(0.0, 1.0).z, 1.5 + 2.0 * (1.25 / 42 - 0.5 / 504), 1e-14);
}

// alpha = 1e-4 and k = 1/8: l is v mirrored up to the tail of the distribution, of order alpha, and f90 is 1/2 up to 2
// alpha.
TEST(IntegrationMap, OfAMirrorIsTheMaskingTwice)
{
    for (const double NoV : {0.3, 0.7, 1.0}) {
        const dvec3 map = integrationMap(NoV, 0.0);
        const double G1 = NoV / (NoV * 7.0 / 8.0 + 1.0 / 8.0), rise = std::pow(1.0 - NoV, 5);
        EXPECT_NEAR(map.x, G1 * G1 * (1.0 - rise), 2e-4) << "NoV " << NoV;
        EXPECT_NEAR(map.y, G1 * G1 * rise, 1e-4) << "NoV " << NoV;
        EXPECT_NEAR(map.z, 41.0 / 42 * (1.0 - 0.5 * rise), 2e-4) << "NoV " << NoV;
    }
}

// The model itself over all directions of light, by a rule of its own: what it returns of light of radiance 1 is f0 x +
// y + (1 - m) c z. Its 1e-6 in the denominator takes 1e-6 / (4 NoV) of the integral of D V, which is below 1 here.
TEST(IntegrationMap, IsTheIntegralOfTheModel)
{
    const Preset& preset = *findPreset("ggx-burley");
    const QuadratureRule cosines = gaussLegendre(200, 0.0, 1.0), azimuths = gaussLegendre(100, 0.0, kPi);
    for (const double r : {0.45, 0.7, 1.0})
        for (const double NoV : {0.1, 0.5, 0.95})
            for (const double m : {0.0, 0.5, 1.0}) {
                const dvec3 c(0.9, 0.3, 0.0);
                dvec3 returned(0);
                for (std::size_t i = 0; i < cosines.size(); ++i)
                    for (std::size_t j = 0; j < azimuths.size(); ++j) {
                        ShadingPoint point = pointAt(NoV, cosines.nodes[i], azimuths.nodes[j], r);
                        point.baseColor = c;
                        point.metallic = m;
                        returned +=
                            2.0 * cosines.weights[i] * azimuths.weights[j] * evaluateTerms(preset, point).response();
                    }
                const dvec3 map = integrationMap(NoV, r), f0 = dvec3(0.5 * (1.0 - m)) + m * c;
                const dvec3 expected = f0 * map.x + map.y + (1.0 - m) * c * map.z;
                EXPECT_LE(glm::length(returned - expected), 1e-6 / (4.0 * NoV) + 1e-6)
                    << "r " << r << " NoV " << NoV << " m " << m;
            }
}

} // namespace
} // namespace torrance::brdf
