#include "prepare/environment_maps.h"

#include "brdf/phong_levels.h"
#include "core/parallel.h"
#include "math/cube.h"
#include "math/latlong.h"
#include "math/quadrature.h"
#include "math/spherical_harmonics.h"
#include "prepare/ggx_prefilter.h"
#include "prepare/irradiance.h"
#include "tests/panorama_of.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

namespace torrance {
namespace {

/// A sky, a horizon, a ground with stripes, and soft lamps of different colours: contrast, but nothing below a few
/// texels.
dvec3 landscape(const dvec3& d)
{
    const dvec3 sky = glm::mix(dvec3(1.0, 0.9, 0.8), dvec3(0.2, 0.4, 1.0), std::sqrt(std::max(d.y, 0.0)));
    const dvec3 ground = dvec3(0.15, 0.1, 0.05) * (1.5 + std::sin(12.0 * d.x) * std::cos(9.0 * d.z));
    const double lamp = 20.0 * std::exp(-60.0 * (1.0 - glm::dot(d, glm::normalize(dvec3(1, 1, 0.4)))));
    return glm::mix(ground, sky, 0.5 + 0.5 * std::tanh(12.0 * d.y)) + lamp * dvec3(1.0, 0.6, 0.2);
}

Image landscapeWithSun(int width, float sun)
{
    Image image = test::panoramaOf(landscape, width).radiance;
    for (int c = 0; c < 3; ++c)
        image.at(width / 5, width / 7)[c] = sun;
    return image;
}

dvec3 texelOf(const std::vector<float>& level, int face, int x, int y, int size)
{
    const float* t = level.data() + 4 * cubeTexelIndex(face, x, y, size);
    return {t[0], t[1], t[2]};
}

/// All light of a panorama as points in double: a texel is one, a sun's (over 1000) 8 x 8, for those whom it grazes.
struct PointLight
{
    dvec3 direction;
    dvec3 radiance;
    double solidAngle;
};

std::vector<PointLight> pointsOf(const Image& image)
{
    std::vector<PointLight> points;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const float* rgb = image.at(x, y);
            const int grid = rgb[1] > 1000.0f ? 8 : 1;
            const int columns = image.width * grid, rows = image.height * grid;
            for (int j = y * grid; j < (y + 1) * grid; ++j)
                for (int i = x * grid; i < (x + 1) * grid; ++i)
                    points.push_back({directionFromLatLong({(i + 0.5) / columns, (j + 0.5) / rows}),
                                      dvec3(rgb[0], rgb[1], rgb[2]), latLongTexelSolidAngle(j, columns, rows)});
        }
    return points;
}

/// The definition: the mean of all light under a zonal kernel of cos(theta).
dvec3 bruteForce(const std::vector<PointLight>& points, const dvec3& n, const std::function<double(double)>& kernel)
{
    dvec3 sum(0.0);
    double weights = 0.0;
    for (const PointLight& point : points) {
        const double cosine = glm::dot(point.direction, n);
        if (cosine <= 0.0)
            continue;
        const double k = kernel(cosine) * point.solidAngle;
        sum += k * point.radiance;
        weights += k;
    }
    return sum / weights;
}

/// D(h) NoL with the half vector at half the angle: Walter et al. 2007, eq. 33.
double splitSumKernel(double cosine, double alpha)
{
    const double cos2H = 0.5 * (1.0 + cosine);
    const double d = cos2H * (alpha * alpha - 1.0) + 1.0;
    return cosine / (d * d);
}

struct Worst
{
    double error = 0.0;
    int face = 0, x = 0, y = 0;
};

/// The largest |got - truth| / (truth + floor) over every `step`-th texel of a level.
Worst worstOfLevel(const Image& image, const std::vector<float>& level, int size, int step, double floor,
                   const std::function<double(double)>& kernel)
{
    const int n = (size + step - 1) / step;
    const std::vector<PointLight> points = pointsOf(image);
    std::vector<Worst> found(static_cast<std::size_t>(kCubeFaces * n * n));
    parallelFor(found.size(), 1, [&](std::size_t i) {
        const int k = static_cast<int>(i);
        const int face = k / (n * n), x = k % n * step, y = k / n % n * step;
        const dvec3 truth = bruteForce(points, cubeTexelDirection(face, x, y, size), kernel);
        const dvec3 apart = glm::abs(texelOf(level, face, x, y, size) - truth) / (truth + floor);
        found[i] = {std::max({apart.x, apart.y, apart.z}), face, x, y};
    });
    Worst worst;
    for (const Worst& each : found)
        if (!(each.error <= worst.error))
            worst = each;
    return worst;
}

double energyOf(const std::vector<float>& level, int size)
{
    double sum = 0.0;
    for (int face = 0; face < kCubeFaces; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                sum += texelOf(level, face, x, y, size).g * cubeTexelSolidAngle(x, y, size);
    return sum;
}

double energyOf(const Image& image)
{
    double sum = 0.0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            sum += static_cast<double>(image.at(x, y)[1]) * latLongTexelSolidAngle(y, image.width, image.height);
    return sum;
}

TEST(EnvironmentMaps, LevelsFollowTheShadersFormula)
{
    EXPECT_EQ(levelAlpha(0, 6), 0.0);
    EXPECT_NEAR(levelAlpha(5, 6), 1.0, 1e-15);
    for (int level = 0; level < 6; ++level) {
        EXPECT_NEAR(5.0 * std::log2(1.0 + 100.0 * levelAlpha(level, 6)) / std::log2(101.0), level, 1e-12);
        EXPECT_NEAR(alphaLevel(levelAlpha(level, 6), 6), level, 1e-12);
    }
    EXPECT_EQ(cubeSizeFor(2), 16);
    EXPECT_EQ(cubeSizeFor(1000), 256);
    EXPECT_EQ(cubeSizeFor(1024), 256);
    EXPECT_EQ(cubeSizeFor(1025), 512);
    EXPECT_EQ(cubeSizeFor(16384), 512);
    EXPECT_EQ(drawnCubeSize(1024, kManyDirections - 1), 256);
    EXPECT_EQ(drawnCubeSize(1024, kManyDirections), 512);
    EXPECT_EQ(drawnCubeSize(2048, kManyDirections), 512) << "no greater than any";
}

TEST(EnvironmentMaps, KernelIntegralIsTheClosedForm)
{
    for (const double alpha : {0.015, 0.1, 0.5, 0.9999, 1.0}) {
        // x = 1 - t^4 crowds the nodes at the peak
        const double sum = integrate(gaussLegendre(200, 0.0, 1.0), [&](double t) {
            const double q = 0.5 * std::pow(t, 4);
            const double d = alpha * alpha + (1.0 - alpha * alpha) * q;
            return 2.0 * kPi * 4.0 * std::pow(t, 3) * (1.0 - 2.0 * q) / (d * d);
        });
        EXPECT_NEAR(ggxKernelIntegral(alpha) / sum, 1.0, 1e-7) << "alpha " << alpha;
    }
}

TEST(EnvironmentMaps, AConstantStaysConstant)
{
    for (const double value : {1.0, 0.3, 5e4}) {
        const Image image = test::panoramaOf([&](const dvec3&) { return value * dvec3(1.0, 0.5, 0.25); }, 128).radiance;
        const EnvironmentMaps maps = makeEnvironmentMaps(image);
        const auto expectConstant = [&](const CubeLevels& cube) {
            for (int level = 0; level < cube.levels; ++level)
                for (std::size_t i = 0; i < cube.data[static_cast<std::size_t>(level)].size(); i += 4) {
                    const float* t = cube.data[static_cast<std::size_t>(level)].data() + i;
                    ASSERT_NEAR(t[0] / value, 1.0, 1e-6) << "level " << level << " texel " << i / 4;
                    ASSERT_NEAR(t[2] / value, 0.25, 1e-6);
                    ASSERT_EQ(t[3], 1.0f);
                }
        };
        expectConstant(maps.specular);
        expectConstant(maps.irradiance);
        const std::array<vec3, 9> sh = irradianceHarmonics(image);
        EXPECT_NEAR(sh[0].r * shBasis({0, 0, 1})[0] / value, 1.0, 1e-6);
        for (std::size_t i = 1; i < 9; ++i)
            EXPECT_NEAR(sh[i].r / value, 0.0, 2e-4); // the midpoints of 64 rows see a trace of band 2
    }
}

TEST(EnvironmentMaps, BlackStaysBlack)
{
    for (const auto& level : makeEnvironmentMaps(Image(32, 16, 3)).specular.data)
        for (std::size_t i = 0; i < level.size(); ++i)
            ASSERT_EQ(level[i], i % 4 == 3 ? 1.0f : 0.0f);
}

TEST(EnvironmentMaps, TakeEveryShapeOfPanorama)
{
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(2, 1), std::pair(3, 7), std::pair(130, 20)})
        for (const auto& level : makeEnvironmentMaps(Image(width, height, 3, 0.5f)).specular.data)
            for (std::size_t i = 0; i < level.size(); ++i)
                ASSERT_NEAR(level[i], i % 4 == 3 ? 1.0f : 0.5f, 1e-6f) << width << " x " << height;
}

class EnvironmentMapsOfSuns : public testing::TestWithParam<float>
{
};

TEST_P(EnvironmentMapsOfSuns, PrefilteredLevelsAreTheZonalMeans)
{
    const Image image = landscapeWithSun(256, GetParam());
    const EnvironmentMaps maps = makeEnvironmentMaps(image);
    ASSERT_EQ(maps.specular.levels, 4);
    // Beside 1 % of the local value, 1e-4 of the mean: receivers that a sun of 1.4 degrees grazes see the shape of its
    // texel.
    const double mean = energyOf(image) / (4.0 * kPi);
    for (int level = 1; level < maps.specular.levels; ++level) {
        const double alpha = levelAlpha(level, maps.specular.levels);
        const Worst worst =
            worstOfLevel(image, maps.specular.data[static_cast<std::size_t>(level)], maps.specular.sizeOf(level),
                         7 - 2 * level, 0.07 * mean, [&](double cosine) { return splitSumKernel(cosine, alpha); });
        EXPECT_LT(worst.error, 0.01) << "level " << level << " face " << worst.face << " texel " << worst.x << ", "
                                     << worst.y;
    }
}

// The same of the cosine powers of source E.
TEST(EnvironmentMaps, PhongLevelsAreTheZonalMeans)
{
    const Image image = landscapeWithSun(256, 1e6f);
    const EnvironmentMaps maps = makePhongMaps(image);
    ASSERT_EQ(maps.specular.levels, brdf::kPhongLevels);
    const double mean = energyOf(image) / (4.0 * kPi);
    for (int level = 1; level < maps.specular.levels; ++level) {
        const double s = 2.0 * std::pow(7.0 / level, 4) - 2.0; // rough = level / 7 = sqrt(sqrt(2 / (s + 2)))
        const int size = maps.specular.sizeOf(level);
        const std::vector<float>& texels = maps.specular.data[static_cast<std::size_t>(level)];
        const Worst worst = worstOfLevel(image, texels, size, std::max(1, size / 4), 0.07 * mean,
                                         [&](double cosine) { return std::pow(cosine, s); });
        EXPECT_LT(worst.error, 0.01) << "level " << level << " face " << worst.face << " texel " << worst.x << ", "
                                     << worst.y;
        EXPECT_NEAR(energyOf(texels, size) / energyOf(image), 1.0, 0.01) << "level " << level;
    }
}

// The same of GGX at the roughnesses of source B.
TEST(EnvironmentMaps, GgxLevelsAreTheZonalMeans)
{
    const Image image = landscapeWithSun(256, 1e6f);
    const EnvironmentMaps maps = makeGgxLevelMaps(image);
    ASSERT_EQ(maps.specular.levels, 6); // the environment, and five above it
    const double mean = energyOf(image) / (4.0 * kPi);
    for (int level = 1; level < maps.specular.levels; ++level) {
        const double r = level / 5.0; // lod = 5 r
        const int size = maps.specular.sizeOf(level);
        const std::vector<float>& texels = maps.specular.data[static_cast<std::size_t>(level)];
        const Worst worst = worstOfLevel(image, texels, size, size / 4, 0.07 * mean,
                                         [&](double cosine) { return splitSumKernel(cosine, r * r); });
        EXPECT_LT(worst.error, 0.01) << "level " << level << " face " << worst.face << " texel " << worst.x << ", "
                                     << worst.y;
        EXPECT_NEAR(energyOf(texels, size) / energyOf(image), 1.0, 5e-3) << "level " << level;
    }
}

TEST_P(EnvironmentMapsOfSuns, EveryLevelHasThePanoramasEnergy)
{
    const Image image = landscapeWithSun(256, GetParam());
    const EnvironmentMaps maps = makeEnvironmentMaps(image);
    EXPECT_NEAR(energyOf(maps.specular.data[0], maps.specular.size) / energyOf(image), 1.0, 1e-3);
    for (int level = 1; level < maps.specular.levels; ++level)
        EXPECT_NEAR(energyOf(maps.specular.data[static_cast<std::size_t>(level)], maps.specular.sizeOf(level)) /
                        energyOf(image),
                    1.0, 5e-3)
            << "level " << level;
    EXPECT_NEAR(energyOf(maps.irradiance.data[0], kIrradianceSize) / energyOf(image), 1.0, 1e-3);
}

TEST_P(EnvironmentMapsOfSuns, IrradianceIsTheCosineMean)
{
    const Image image = landscapeWithSun(512, GetParam());
    const EnvironmentMaps maps = makeEnvironmentMaps(image);
    // The floor of a tenth of the mean is for receivers that a sun of 0.7 degrees grazes: their light hangs on its
    // shape.
    const double mean = energyOf(image) / (4.0 * kPi);
    const Worst worst = worstOfLevel(image, maps.irradiance.data[0], kIrradianceSize, 9, 0.1 * mean,
                                     [](double cosine) { return cosine; });
    EXPECT_LT(worst.error, 1e-3) << "face " << worst.face << " texel " << worst.x << ", " << worst.y;
}

INSTANTIATE_TEST_SUITE_P(EnvironmentMaps, EnvironmentMapsOfSuns, testing::Values(0.0f, 1e5f, 1e6f, 1e9f));

TEST(EnvironmentMaps, HarmonicsAreTheIrradianceOfALowOrderSky)
{
    // Radiance of bands 0 to 2 only: its irradiance / pi is known in closed form, band by band.
    const auto radiance = [](const dvec3& d) { return dvec3(2.0 + d.x - 0.5 * d.y + 0.25 * d.x * d.z); };
    const Image image = test::panoramaOf(radiance, 256).radiance;
    const EnvironmentMaps maps = makeEnvironmentMaps(image);
    const std::array<vec3, 9> sh = irradianceHarmonics(image);
    for (const dvec3& n : {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1), glm::normalize(dvec3(-1, 2, 3))}) {
        const double expected = 2.0 + 2.0 / 3.0 * (n.x - 0.5 * n.y) + 0.25 * 0.25 * n.x * n.z;
        double sum = 0.0;
        for (std::size_t i = 0; i < 9; ++i)
            sum += sh[i].g * shBasis(n)[i];
        EXPECT_NEAR(sum, expected, 1e-3);
        const CubePoint p = cubePoint(n);
        const auto at = [&](double a) {
            return std::min(static_cast<int>((a + 1.0) * 0.5 * kIrradianceSize), kIrradianceSize - 1);
        };
        const dvec3 centre = cubeTexelDirection(p.face, at(p.a), at(p.b), kIrradianceSize);
        const double there = 2.0 + 2.0 / 3.0 * (centre.x - 0.5 * centre.y) + 0.25 * 0.25 * centre.x * centre.z;
        EXPECT_NEAR(texelOf(maps.irradiance.data[0], p.face, at(p.a), at(p.b), kIrradianceSize).g, there, 1e-3 * there);
    }
}

TEST(EnvironmentMaps, LevelZeroLiesAsThePanoramaDoes)
{
    const Image image = test::panoramaOf(landscape, 512).radiance;
    const EnvironmentMaps maps = makeEnvironmentMaps(image);
    const int size = maps.specular.size;
    for (int face = 0; face < kCubeFaces; ++face)
        for (int y = 0; y < size; y += 7)
            for (int x = 0; x < size; x += 7) {
                const dvec3 expected = landscape(cubeTexelDirection(face, x, y, size));
                const dvec3 got = texelOf(maps.specular.data[0], face, x, y, size);
                EXPECT_NEAR(got.r, expected.r, 0.02 * expected.r + 0.02)
                    << "face " << face << " texel " << x << ", " << y;
                EXPECT_NEAR(got.b, expected.b, 0.02 * expected.b + 0.02)
                    << "face " << face << " texel " << x << ", " << y;
            }
}

TEST(EnvironmentMaps, AreTheSameEveryTime)
{
    const Image image = landscapeWithSun(64, 1e6f);
    EXPECT_EQ(makeEnvironmentMaps(image).specular.data, makeEnvironmentMaps(image).specular.data);
}

} // namespace
} // namespace torrance
