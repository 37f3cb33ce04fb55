#include "brdf/ggx_levels.h"

#include "brdf/integration_map.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

TEST(GgxLevels, HoldTheRoughnessThatReadsThem)
{
    EXPECT_EQ(ggxLevelAlpha(0), 0.0);
    EXPECT_NEAR(ggxLevelAlpha(2), 0.16, 1e-15);
    EXPECT_EQ(ggxLevelAlpha(5), 1.0);
    EXPECT_NEAR(ggxLevel(0.4), 2.0, 1e-15);
    EXPECT_EQ(ggxLevel(1.0), 5.0);
    EXPECT_NEAR(ggxLevel(0.0), 0.05, 1e-15) << "roughness of 0.01 or more";
    EXPECT_EQ(ggxLevel(0.9, 4), 4.0);
    EXPECT_NEAR(ggxLevel(0.7, 4), 3.5, 1e-15);
}

/// Means of the cosine under D(h) n.l with h at half its angle: the kernel is x / (A - B x)^2, A = (1 + alpha^2) / 2
/// and B = (1 - alpha^2) / 2, whose moments follow from u = A - B x; 2/3 of alpha = 1.
double meanCosine(double alpha)
{
    const double a2 = alpha * alpha, A = 0.5 * (1.0 + a2), B = 0.5 * (1.0 - a2), ratio = std::log(A / a2);
    if (B == 0.0)
        return 2.0 / 3.0;
    const double weight = (A / a2 - 1.0 - ratio) / (B * B);
    const double first = (A * (A / a2 - 1.0) - 2.0 * A * ratio + A - a2) / (B * B * B);
    return first / weight;
}

// Light that is linear in the direction: each level is its closed form, and roughness between two is their mean.
TEST(GgxLevels, OfLinearLightAreTheClosedForm)
{
    EnvironmentQuery query;
    query.n = glm::normalize(dvec3(0.3, -0.5, 0.6));
    const dvec3 t = glm::normalize(glm::cross(query.n, dvec3(0, 1, 0)));
    query.v = query.n * 0.6 + t * 0.8;
    query.f0 = dvec3(1, 0.5, 0.04);
    const dvec3 mirror = query.n * 0.6 - t * 0.8;
    query.radiance = [&](const dvec3& d) { return dvec3(1, 1 + glm::dot(d, mirror), 2 + d.x); };
    const auto closedForm = [&](double level) {
        const double mean = level == 0.0 ? 1.0 : meanCosine(std::pow(level / 5.0, 2));
        return dvec3(1, 1 + mean, 2 + mean * mirror.x);
    };
    // 48 of Gauss' nodes leave rho^-96, where the pole at u = 1 / (1 - alpha^2) of [0, 1 / (1 + alpha^2)] gives rho = 1
    // + sqrt(8) alpha for small alpha: 3.5e-5 of level 1, 1e-12 and less of the others, which rounding reaches first.
    const auto quadrature = [](double level) { return level < 2.0 ? 3.5e-5 : 1e-12; };
    for (const double level : {1.0, 2.0, 3.0, 4.0, 5.0}) {
        query.perceptualRoughness = level / 5.0;
        const dvec3 map = integrationMap(0.6, query.perceptualRoughness);
        EXPECT_LE(glm::length(ggxLevelRadiance(query) - closedForm(level)), quadrature(level)) << level;
        EXPECT_LE(glm::length(Es_ggx_levels(query) - closedForm(level) * (query.f0 * map.x + map.y)), quadrature(level))
            << level;
    }
    query.perceptualRoughness = 0.05; // a quarter from level 0, the light itself, to level 1
    EXPECT_LE(glm::length(ggxLevelRadiance(query) - (0.75 * closedForm(0) + 0.25 * closedForm(1))), quadrature(1));
    query.perceptualRoughness = 0.95; // of five levels the last is 4
    EXPECT_LE(glm::length(ggxLevelRadiance(query, 4) - closedForm(4)), quadrature(4));
    EXPECT_LE(glm::length(ggxLevelRadiance(query) - (0.25 * closedForm(4) + 0.75 * closedForm(5))), quadrature(4));
}

} // namespace
} // namespace torrance::brdf
