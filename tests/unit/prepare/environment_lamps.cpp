#include "prepare/environment_lamps.h"

#include "math/cube.h"

#include <gtest/gtest.h>

#include <cmath>

namespace torrance {
namespace {

constexpr int kSize = 32;
const dvec3 kSun = glm::normalize(dvec3(0.3, 0.8, -0.4)), kWindow = glm::normalize(dvec3(-1.0, 0.1, 0.2));

// A sky, a small sun and a window, whose mean would not show the sky.
dvec3 sky(const dvec3& d)
{
    dvec3 radiance = dvec3(0.4, 0.5, 0.7) * (1.0 + 0.3 * d.y);
    if (glm::dot(d, kSun) > 0.997)
        radiance += dvec3(2000.0, 1800.0, 1500.0);
    if (glm::dot(d, kWindow) > 0.95)
        radiance += dvec3(12.0);
    return radiance;
}

std::vector<float> cubeOf(dvec3 (*radiance)(const dvec3&))
{
    std::vector<float> texels;
    for (int face = 0; face < kCubeFaces; ++face)
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x) {
                const dvec3 value = radiance(cubeTexelDirection(face, x, y, kSize));
                texels.insert(texels.end(), {float(value.r), float(value.g), float(value.b), 1.0f});
            }
    return texels;
}

template <typename Function>
void forEachTexel(const Function& f)
{
    for (int face = 0; face < kCubeFaces; ++face)
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x)
                f(4 * cubeTexelIndex(face, x, y, kSize), cubeTexelDirection(face, x, y, kSize),
                  cubeTexelSolidAngle(x, y, kSize));
}

TEST(EnvironmentLamps, BothPartsAreTheWholeAndTheRestIsGentle)
{
    const std::vector<float> whole = cubeOf(sky);
    const EnvironmentLamps split = splitLamps(whole, kSize, 64);
    // The sky's mean over the sphere is 8/15, of which at most kLampFactor stay.
    forEachTexel([&](std::size_t i, const dvec3& d, double) {
        const std::vector<float>&rest = split.rest.data[0], &lamps = split.lamps.data[0];
        double mean = 0.0;
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(rest[i + c] + lamps[i + c], whole[i + c], 1e-6f * whole[i + c]);
            mean += rest[i + c] / 3.0;
        }
        EXPECT_LT(mean, kLampFactor * 1.2 * 8.0 / 15.0);
        const bool shines = glm::dot(d, kSun) > 0.997 || glm::dot(d, kWindow) > 0.95;
        EXPECT_EQ(lamps[i] > 0.0f, shines);
    });
}

double meanOf(const float* lamp)
{
    return (double(lamp[0]) + double(lamp[1]) + double(lamp[2])) / 3.0;
}

TEST(EnvironmentLamps, PointsHaveTheLightOfTheLampsAndTheDensityOfTheirKind)
{
    for (const int count : {6, 64, 256}) {
        const EnvironmentLamps split = splitLamps(cubeOf(sky), kSize, count);
        ASSERT_EQ(split.points.size(), static_cast<std::size_t>(count));
        dvec3 energy(0.0), expected(0.0);
        int inside = 0;
        for (const brdf::LampPoint& point : split.points) {
            energy += point.energy;
            // Under the point lies its own region, a rectangle of a face.
            const CubePoint at = cubePoint(point.direction);
            const auto texelOf = [](double a) {
                return std::min(static_cast<int>((a + 1.0) / 2.0 * kSize), kSize - 1);
            };
            const float* lamp = &split.lamps.data[0][4 * cubeTexelIndex(at.face, texelOf(at.a), texelOf(at.b), kSize)];
            if (point.density > 0.0 && meanOf(lamp) > 0.0) {
                const bool small = lamp[3] > 0.0f;
                EXPECT_EQ(point.density, small ? split.densities.small : split.densities.wide) << count;
                EXPECT_TRUE(!small || std::abs(lamp[3] - meanOf(lamp)) <= 1e-6 * meanOf(lamp)) << count;
                ++inside;
            }
        }
        EXPECT_GT(inside, 1);
        forEachTexel([&](std::size_t i, const dvec3&, double omega) {
            const float* lamp = &split.lamps.data[0][i];
            expected += omega * dvec3(lamp[0], lamp[1], lamp[2]);
        });
        EXPECT_LT(glm::distance(energy, expected), 1e-5 * glm::length(expected)) << count;
    }
}

// Where lamps are of two brightnesses the kinds are these lamps, and their densities the shares of light on a steradian
// of each, whatever else the regions reach to.
TEST(EnvironmentLamps, SunsAreSmallLampsAndWindowsAreWideOnes)
{
    const EnvironmentLamps split = splitLamps(cubeOf(sky), kSize, 512);
    double sun = 0.0, window = 0.0, sunAngle = 0.0, windowAngle = 0.0;
    forEachTexel([&](std::size_t i, const dvec3& d, double omega) {
        const float* lamp = &split.lamps.data[0][i];
        const bool ofSun = glm::dot(d, kSun) > 0.997;
        EXPECT_EQ(lamp[3] > 0.0f, ofSun);
        (ofSun ? sun : window) += omega * meanOf(lamp);
        (ofSun ? sunAngle : windowAngle) += meanOf(lamp) > 0.0 ? omega : 0.0;
    });
    EXPECT_NEAR(split.densities.small, sun / (sunAngle * (sun + window)), 0.01 * split.densities.small);
    EXPECT_NEAR(split.densities.wide, window / (windowAngle * (sun + window)), 0.01 * split.densities.wide);
}

TEST(EnvironmentLamps, LampsOfOneBrightnessAreOneKind)
{
    const EnvironmentLamps split = splitLamps(
        cubeOf(+[](const dvec3& d) { return glm::dot(d, kWindow) > 0.95 ? dvec3(12.0) : dvec3(0.5); }), kSize, 64);
    double angle = 0.0;
    forEachTexel(
        [&](std::size_t i, const dvec3&, double omega) { angle += split.lamps.data[0][i] > 0.0f ? omega : 0.0; });
    EXPECT_NEAR(split.densities.small * angle, 1.0, 1e-6);
    EXPECT_NEAR(split.densities.wide * angle, 1.0, 1e-6);
}

// Sums over regions are differences of sums over faces: beside a sun of nearly all light, those over other lamps are
// partly rounding, or nothing else.
template <int kExponent>
dvec3 sunAmongBulbs(const dvec3& d)
{
    if (d.y > 0.99)
        return dvec3(1e12);
    const dvec3 bulb = glm::normalize(dvec3(std::copysign(0.5, d.x), 1.0, std::copysign(0.5, d.z)));
    return glm::dot(d, bulb) > 0.99 ? dvec3(std::pow(10.0, kExponent)) : dvec3(0.0);
}

TEST(EnvironmentLamps, BesideAFarBrighterOneLampsKeepTheirLight)
{
    for (const auto& radiance : {sunAmongBulbs<6>, sunAmongBulbs<3>, sunAmongBulbs<0>}) {
        const std::vector<float> whole = cubeOf(radiance);
        const EnvironmentLamps split = splitLamps(whole, kSize, 64);
        EXPECT_TRUE(std::isfinite(split.densities.wide) && split.densities.wide > 0.0);
        EXPECT_TRUE(std::isfinite(split.densities.small) && split.densities.small > 0.0);
        double places = 0.0, points = 0.0; // of bulbs
        forEachTexel([&](std::size_t i, const dvec3& d, double) {
            EXPECT_NEAR(split.rest.data[0][i] + split.lamps.data[0][i], whole[i], 1e-6 * whole[i]);
            places += d.y < 0.99 && split.lamps.data[0][i] > 0.0f ? 1.0 : 0.0;
        });
        for (const brdf::LampPoint& point : split.points)
            points += point.energy.r > 0.0 && point.energy.r < 1e9 ? 1.0 : 0.0;
        EXPECT_EQ(places > 0.0, points > 0.0) << "what no point stands for is no lamp's";
    }
}

// More points lie nearer to what they stand for: the mean distance of lamps' light from its point falls like the root
// of their number, as regions of a plane do.
TEST(EnvironmentLamps, MorePointsAreNearerToTheirLight)
{
    const std::vector<float> whole = cubeOf(sky);
    const auto meanDistance = [&](int count) {
        const EnvironmentLamps split = splitLamps(whole, kSize, count);
        double distance = 0.0, light = 0.0;
        forEachTexel([&](std::size_t i, const dvec3& d, double omega) {
            const double mean = split.lamps.data[0][i] * omega;
            if (!(mean > 0.0))
                return;
            double nearest = 2.0;
            for (const brdf::LampPoint& point : split.points)
                if (point.density > 0.0)
                    nearest = std::min(nearest, glm::distance(point.direction, d));
            distance += mean * nearest;
            light += mean;
        });
        return distance / light;
    };
    EXPECT_LT(meanDistance(64), 0.5 * meanDistance(8));
}

TEST(EnvironmentLamps, AnEvenOrDarkSkyHasNone)
{
    for (const auto& radiance : {+[](const dvec3&) { return dvec3(3.0); }, +[](const dvec3&) { return dvec3(0.0); }}) {
        const std::vector<float> whole = cubeOf(radiance);
        const EnvironmentLamps split = splitLamps(whole, kSize, 64);
        EXPECT_EQ(split.points.size(), 64u);
        for (const brdf::LampPoint& point : split.points)
            EXPECT_EQ(point.energy, dvec3(0.0));
        forEachTexel([&](std::size_t i, const dvec3&, double) {
            EXPECT_EQ(split.rest.data[0][i], whole[i]);
            EXPECT_EQ(split.lamps.data[0][i], 0.0f);
        });
    }
}

} // namespace
} // namespace torrance
