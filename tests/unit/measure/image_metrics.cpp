#include "measure/image_metrics.h"

#include "measure/statistics.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

Image twoPixels(float a, float b)
{
    Image image(2, 1, 1);
    image.texels = {a, b};
    return image;
}

TEST(ImageMetrics, AreWhatTheirDefinitionsSay)
{
    // By hand. Reference 1 and 3, test 2 and 3: differences 1 and 0.
    const ImageMetrics metrics = compareImages(twoPixels(1, 3), twoPixels(2, 3));
    EXPECT_NEAR(metrics.relMse, 0.5 / 1.01, 1e-15);
    EXPECT_NEAR(metrics.rmse, std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(metrics.smape, 0.5 / 3.01, 1e-15);
    EXPECT_NEAR(metrics.meanError, 0.25, 1e-15);
    EXPECT_EQ(metrics.worst.x, 0);
    EXPECT_NEAR(metrics.worst.error, 1.0 / (1.0 + 0.01 * 2.0), 1e-15);
}

TEST(ImageMetrics, AreZeroForEqualPictures)
{
    const ImageMetrics metrics = compareImages(twoPixels(0, 7), twoPixels(0, 7));
    EXPECT_EQ(metrics.relMse, 0.0);
    EXPECT_EQ(metrics.rmse, 0.0);
    EXPECT_EQ(metrics.smape, 0.0);
    EXPECT_EQ(metrics.meanError, 0.0);
    EXPECT_EQ(metrics.worst.error, 0.0);
}

TEST(ImageMetrics, CountNonFinitePixelsAndLeaveThemOut)
{
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    const ImageMetrics metrics = compareImages(twoPixels(1, 3), twoPixels(nan, 3));
    EXPECT_EQ(metrics.nonFiniteReference, 0u);
    EXPECT_EQ(metrics.nonFiniteTest, 1u);
    EXPECT_EQ(metrics.rmse, 0.0);
    EXPECT_EQ(compareImages(twoPixels(infinity, nan), twoPixels(1, 2)).nonFiniteReference, 2u);
}

TEST(ImageMetrics, AreDefinedForABlackReference)
{
    const ImageMetrics metrics = compareImages(twoPixels(0, 0), twoPixels(0, 0.5f));
    EXPECT_TRUE(std::isinf(metrics.meanError));
    EXPECT_EQ(metrics.worst.x, 1);
    EXPECT_EQ(metrics.worst.error, 0.5);
    EXPECT_NEAR(metrics.relMse, 0.5 * 0.25 / 0.01, 1e-12);
}

TEST(ImageMetrics, FindTheWorstPixelsPlace)
{
    Image reference(7, 5, 3, 1.0f), test = reference;
    test.at(4, 2)[1] = 1.5f;
    test.at(1, 3)[0] = 1.25f;
    const WorstPixel worst = compareImages(reference, test).worst;
    EXPECT_EQ(worst.x, 4);
    EXPECT_EQ(worst.y, 2);
    EXPECT_NEAR(worst.error, 0.5 / 3.03, 1e-15);
}

TEST(Statistics, PercentileIsTheNearestRank)
{
    std::vector<float> values;
    for (int i = 100; i >= 1; --i)
        values.push_back(static_cast<float>(i));
    EXPECT_EQ(percentile(values, 0.99), 99.0);
    EXPECT_EQ(percentile(values, 1.0), 100.0);
    EXPECT_EQ(percentile(values, 0.001), 1.0);
    EXPECT_EQ(percentile({}, 0.99), 0.0);
}

TEST(Statistics, MeanKeepsItsDigitsOverManyValues)
{
    // 0.1f is not a tenth: the mean of equal values is the value.
    const std::vector<float> values(1000003, 0.1f);
    EXPECT_NEAR(mean(values), static_cast<double>(0.1f), 1e-15);
    EXPECT_EQ(mean({}), 0.0);
}

} // namespace
} // namespace torrance
