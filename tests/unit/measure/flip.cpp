// FLIP against NVIDIA's own implementation (github.com/NVlabs/flip, v1.6, CPU, single precision), which was given the
// same pictures (flip_pictures.h), and against what the papers say of special cases.
#include "measure/flip.h"

#include "flip_pictures.h"
#include "measure/flip_filter.h"
#include "measure/statistics.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

using test::flipHighRange;
using test::flipReference;
using test::flipTest;

struct Expected
{
    int x, y;
    double flip;
};

void expectMap(const Image& map, std::initializer_list<Expected> expected, double tolerance)
{
    for (const Expected& pixel : expected)
        EXPECT_NEAR(*map.at(pixel.x, pixel.y), pixel.flip, tolerance) << "pixel " << pixel.x << " " << pixel.y;
}

TEST(Flip, AgreesWithThePublishedProgramOnDisplayReferredPictures)
{
    const Image map = ldrFlip(flipReference(), flipTest());
    // The published program works in float: sums of 21 + 21 weighted values, a cube root and three powers, about 1e-6.
    EXPECT_NEAR(mean(map.texels), 0.139231727, 1e-6);
    expectMap(map,
              {{0, 0, 0.9626584},
               {5, 9, 0.4358667},
               {40, 10, 0.4444182},
               {41, 30, 0.5241004},
               {23, 19, 0.1630313},
               {63, 47, 0.01416451},
               {12, 40, 0.00847987},
               {50, 24, 0.01212802}},
              2e-6);
    EXPECT_NEAR(percentile(map.texels, 0.99), 0.6580715, 2e-6);
}

TEST(Flip, AgreesWithThePublishedProgramOnHighRangePictures)
{
    const Image reference = flipHighRange(flipReference());
    const FlipExposures exposures = flipExposures(reference);
    // The published program rounds the weights of luminance to four digits (0.2126 for 0.21264): 2e-4 of the smallest
    // of them, which moves an exposure by up to 2e-4 / ln 2 = 3e-4 stops, and FLIP, whose slope is below 0.1 a stop, by
    // 3e-5.
    EXPECT_NEAR(exposures.start, -3.2708869, 3e-4);
    EXPECT_NEAR(exposures.stop, 2.60779738, 3e-4);
    EXPECT_EQ(exposures.count, 6);
    const Image map = hdrFlip(reference, flipHighRange(flipTest()));
    EXPECT_NEAR(mean(map.texels), 0.0858333906, 3e-5);
    expectMap(map,
              {{0, 0, 0.2534837},
               {5, 9, 0.1292636},
               {40, 10, 0.3670434},
               {41, 30, 0.4037582},
               {23, 19, 0.124424},
               {63, 47, 0.01012454},
               {12, 40, 0.006442833},
               {50, 24, 0.008348474}},
              3e-5);
    EXPECT_NEAR(percentile(map.texels, 0.99), 0.491468, 3e-5);
}

TEST(Flip, IsZeroForEqualPictures)
{
    for (const float value : ldrFlip(flipReference(), flipReference()).texels)
        EXPECT_EQ(value, 0.0f);
    const Image bright = flipHighRange(flipReference());
    for (const float value : hdrFlip(bright, bright).texels)
        EXPECT_EQ(value, 0.0f);
}

TEST(Flip, IsOneBetweenTheColoursThatLieFarthestApart)
{
    // The largest distance is that of green and blue (2020, section 4.1.4); flat pictures have no features.
    Image green(32, 32, 3), blue(32, 32, 3);
    for (std::size_t i = 0; i < green.texels.size(); i += 3)
        green.texels[i + 1] = blue.texels[i + 2] = 1.0f;
    const Image map = ldrFlip(green, blue);
    for (const float value : map.texels)
        EXPECT_NEAR(value, 1.0f, 1e-6f);
}

TEST(Flip, DoesNotDependOnTheOrderOfDisplayReferredPictures)
{
    EXPECT_EQ(ldrFlip(flipReference(), flipTest()).texels, ldrFlip(flipTest(), flipReference()).texels);
}

TEST(Flip, FindsExposuresForBlackBackgrounds)
{
    Image image(10, 10, 3);
    EXPECT_EQ(flipExposures(image).count, 1) << "all black";
    // One pixel in ten is lit: the median is black, that of the lit ones 1, which is the brightest as well.
    for (int x = 0; x < 10; ++x)
        std::fill_n(image.at(x, 3), 3, 1.0f);
    const FlipExposures exposures = flipExposures(image);
    EXPECT_TRUE(std::isfinite(exposures.stop));
    EXPECT_EQ(exposures.start, exposures.stop);
    EXPECT_EQ(exposures.count, 2);
    Image other = image;
    *other.at(5, 3) = -1.0f;
    for (const float value : hdrFlip(image, other).texels)
        EXPECT_TRUE(value >= 0.0f && value <= 1.0f) << value;
}

TEST(FlipFilter, SumsToOneAndToPlusAndMinusOne)
{
    for (const auto channel : {flip::Opponent::achromatic, flip::Opponent::redGreen, flip::Opponent::blueYellow}) {
        double share = 0.0;
        for (const flip::SensitivityTerm& term : flip::sensitivity(channel, 67.0)) {
            double sum = 0.0;
            for (const double weight : term.kernel)
                sum += weight;
            EXPECT_NEAR(sum, 1.0, 1e-14);
            EXPECT_EQ(term.kernel.size(), 21u) << "3 sqrt(0.04 / 2) / pi degrees are 9.05 pixels: a radius of 10";
            share += term.share;
        }
        EXPECT_NEAR(share, 1.0, 1e-14);
    }
    const flip::FeatureKernels kernels = flip::featureKernels(67.0);
    for (const flip::Kernel* kernel : {&kernels.edge, &kernels.point}) {
        double positive = 0.0, negative = 0.0;
        for (const double weight : *kernel)
            (weight > 0 ? positive : negative) += weight;
        EXPECT_NEAR(positive, 1.0, 1e-14);
        EXPECT_NEAR(negative, -1.0, 1e-14);
    }
}

TEST(FlipFilter, RepeatsTheEdge)
{
    flip::Plane plane(2, 1);
    plane.values = {1.0, 3.0};
    // By hand: the left pixel sees 1 1 3, the right one 1 3 3.
    EXPECT_EQ(flip::convolved(plane, {0.25, 0.5, 0.25}, {1.0}).values, (std::vector<double>{1.5, 2.5}));
}

} // namespace
} // namespace torrance
