#include "measure/image_metrics.h"

#include "math/norm.h"

#include <cassert>
#include <cmath>
#include <limits>

namespace torrance {
namespace {

struct Sums
{
    std::size_t pixels = 0;
    double relative = 0.0;
    double square = 0.0;
    double symmetric = 0.0;
    double difference = 0.0; // of |t - r|_1
    double reference = 0.0;  // of |r|_1
};

bool isFinite(const float* texel, int channels)
{
    for (int channel = 0; channel < channels; ++channel)
        if (!std::isfinite(texel[channel]))
            return false;
    return true;
}

void addPixel(const float* reference, const float* test, int channels, Sums& sums)
{
    ++sums.pixels;
    sums.difference += distance1(reference, test, channels);
    sums.reference += norm1(reference, channels);
    for (int channel = 0; channel < channels; ++channel) {
        const double r = reference[channel], t = test[channel], d = t - r;
        sums.square += d * d;
        sums.relative += d * d / (r * r + kRelativeFloor);
        sums.symmetric += std::abs(d) / (std::abs(t) + std::abs(r) + kRelativeFloor);
    }
}

// Calls visit(x, y, reference texel, test texel) for every pixel that is finite in both.
template <typename Visit>
void forFinitePixels(const Image& reference, const Image& test, const Visit& visit)
{
    for (int y = 0; y < reference.height; ++y)
        for (int x = 0; x < reference.width; ++x)
            if (isFinite(reference.at(x, y), reference.channels) && isFinite(test.at(x, y), test.channels))
                visit(x, y, reference.at(x, y), test.at(x, y));
}

std::size_t nonFinitePixels(const Image& image)
{
    std::size_t count = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            count += isFinite(image.at(x, y), image.channels) ? 0 : 1;
    return count;
}

WorstPixel worstPixel(const Image& reference, const Image& test, double meanNorm)
{
    WorstPixel worst;
    forFinitePixels(reference, test, [&](int x, int y, const float* r, const float* t) {
        const double scale = meanNorm > 0.0 ? norm1(r, reference.channels) + kPixelFloor * meanNorm : 1.0;
        const double error = distance1(r, t, reference.channels) / scale;
        if (error > worst.error)
            worst = {.x = x, .y = y, .error = error};
    });
    return worst;
}

double ratio(double difference, double reference)
{
    if (difference == 0.0)
        return 0.0;
    return reference > 0.0 ? difference / reference : std::numeric_limits<double>::infinity();
}

} // namespace

ImageMetrics compareImages(const Image& reference, const Image& test)
{
    assert(reference.width == test.width && reference.height == test.height && reference.channels == test.channels);
    Sums sums;
    forFinitePixels(reference, test,
                    [&](int, int, const float* r, const float* t) { addPixel(r, t, reference.channels, sums); });
    ImageMetrics metrics;
    metrics.nonFiniteReference = nonFinitePixels(reference);
    metrics.nonFiniteTest = nonFinitePixels(test);
    if (sums.pixels == 0)
        return metrics;
    const double pixels = static_cast<double>(sums.pixels), values = pixels * reference.channels;
    metrics.relMse = sums.relative / values;
    metrics.rmse = std::sqrt(sums.square / values);
    metrics.smape = sums.symmetric / values;
    metrics.meanError = ratio(sums.difference, sums.reference);
    metrics.worst = worstPixel(reference, test, sums.reference / pixels);
    return metrics;
}

} // namespace torrance
