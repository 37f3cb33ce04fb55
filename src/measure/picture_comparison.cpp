#include "measure/picture_comparison.h"

#include "measure/flip.h"
#include "measure/statistics.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

constexpr double kFlipRank = 0.99;

Image finite(const Image& image)
{
    Image result = image;
    for (float& value : result.texels)
        value = std::isfinite(value) ? value : 0.0f;
    return result;
}

double alphaDifference(const Image& reference, const Image& test)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < std::max(reference.texels.size(), test.texels.size()); ++i) {
        const double a = reference.texels.empty() ? 1.0 : reference.texels[i];
        const double b = test.texels.empty() ? 1.0 : test.texels[i];
        const double difference = std::abs(a - b);
        largest = difference > largest || std::isnan(difference) ? difference : largest;
    }
    return largest;
}

} // namespace

PictureComparison comparePictures(const ComparedPicture& reference, const ComparedPicture& test)
{
    PictureComparison comparison;
    comparison.metrics = compareImages(reference.linear, test.linear);
    const Image r = finite(reference.linear), t = finite(test.linear);
    comparison.flipMap = reference.displayReferred ? ldrFlip(r, t) : hdrFlip(r, t);
    comparison.meanFlip = mean(comparison.flipMap.texels);
    comparison.flip99 = percentile(comparison.flipMap.texels, kFlipRank);
    comparison.maxAlphaDifference = alphaDifference(reference.alpha, test.alpha);
    return comparison;
}

} // namespace torrance
