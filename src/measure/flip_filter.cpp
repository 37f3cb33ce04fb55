#include "measure/flip_filter.h"

#include "core/parallel.h"
#include "math/vector.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace torrance::flip {
namespace {

// Three standard deviations hold 99.7 % of a Gaussian: both papers cut there.
constexpr double kCutOff = 3.0;
// Width of the feature detectors in degrees.
constexpr double kFeatureWidth = 0.082;
constexpr std::size_t kRowGrain = 16;

struct Gaussian
{
    double a;
    double b;
};

// 2020, table 1, and the largest b of it, which sets the radius of all three.
constexpr Gaussian kAchromatic[] = {{1.0, 0.0047}};
constexpr Gaussian kRedGreen[] = {{1.0, 0.0053}};
constexpr Gaussian kBlueYellow[] = {{34.1, 0.04}, {13.5, 0.025}};
constexpr double kLargestB = 0.04;

Kernel sampled(int radius, const std::function<double(double)>& f)
{
    Kernel kernel;
    for (int x = -radius; x <= radius; ++x)
        kernel.push_back(f(x));
    return kernel;
}

double sum(const Kernel& kernel)
{
    double total = 0.0;
    for (const double weight : kernel)
        total += weight;
    return total;
}

Kernel normalised(Kernel kernel)
{
    double positive = 0.0, negative = 0.0;
    for (const double weight : kernel)
        (weight > 0.0 ? positive : negative) += std::abs(weight);
    for (double& weight : kernel)
        if (weight != 0.0)
            weight /= weight > 0.0 ? positive : negative;
    return kernel;
}

// The row with its ends repeated `radius` times on either side.
void padRow(const double* row, int width, int radius, std::vector<double>& padded)
{
    padded.assign(static_cast<std::size_t>(width + 2 * radius), row[0]);
    std::copy_n(row, width, padded.begin() + radius);
    std::fill_n(padded.begin() + radius + width, radius, row[width - 1]);
}

Plane convolvedX(const Plane& plane, const Kernel& kernel)
{
    Plane result(plane.width, plane.height);
    const int radius = static_cast<int>(kernel.size() / 2);
    parallelFor(static_cast<std::size_t>(plane.height), kRowGrain, [&](std::size_t index) {
        const int y = static_cast<int>(index);
        std::vector<double> padded;
        padRow(plane.row(y), plane.width, radius, padded);
        double* out = result.row(y);
        for (std::size_t k = 0; k < kernel.size(); ++k)
            for (int x = 0; x < plane.width; ++x)
                out[x] += kernel[k] * padded[k + static_cast<std::size_t>(x)];
    });
    return result;
}

Plane convolvedY(const Plane& plane, const Kernel& kernel)
{
    Plane result(plane.width, plane.height);
    const int radius = static_cast<int>(kernel.size() / 2);
    parallelFor(static_cast<std::size_t>(plane.height), kRowGrain, [&](std::size_t index) {
        const int y = static_cast<int>(index);
        double* out = result.row(y);
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            const double* in = plane.row(std::clamp(y + static_cast<int>(k) - radius, 0, plane.height - 1));
            for (int x = 0; x < plane.width; ++x)
                out[x] += kernel[k] * in[x];
        }
    });
    return result;
}

} // namespace

Plane convolved(const Plane& plane, const Kernel& alongX, const Kernel& alongY)
{
    return convolvedY(convolvedX(plane, alongX), alongY);
}

std::vector<SensitivityTerm> sensitivity(Opponent channel, double pixelsPerDegree)
{
    const int radius =
        static_cast<int>(std::ceil(kCutOff * std::sqrt(kLargestB / (2.0 * kPi * kPi)) * pixelsPerDegree));
    std::vector<Gaussian> gaussians(std::begin(kBlueYellow), std::end(kBlueYellow));
    if (channel == Opponent::achromatic)
        gaussians.assign(std::begin(kAchromatic), std::end(kAchromatic));
    if (channel == Opponent::redGreen)
        gaussians.assign(std::begin(kRedGreen), std::end(kRedGreen));
    std::vector<SensitivityTerm> terms;
    double total = 0.0;
    for (const Gaussian& gaussian : gaussians) {
        const Kernel kernel = sampled(radius, [&](double pixels) {
            const double x = pixels / pixelsPerDegree;
            return std::exp(-kPi * kPi * x * x / gaussian.b);
        });
        // The two-dimensional filter is a sum of products of these: each weighs by the square of its sum.
        const double weight = gaussian.a * std::sqrt(kPi / gaussian.b) * sum(kernel) * sum(kernel);
        terms.push_back({.share = weight, .kernel = normalised(kernel)});
        total += weight;
    }
    for (SensitivityTerm& term : terms)
        term.share /= total;
    return terms;
}

FeatureKernels featureKernels(double pixelsPerDegree)
{
    const double sigma = 0.5 * kFeatureWidth * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(kCutOff * sigma));
    const auto gaussian = [=](double x) { return std::exp(-x * x / (2.0 * sigma * sigma)); };
    return {.smooth = normalised(sampled(radius, gaussian)),
            .edge = normalised(sampled(radius, [=](double x) { return -x * gaussian(x); })),
            .point =
                normalised(sampled(radius, [=](double x) { return (x * x / (sigma * sigma) - 1.0) * gaussian(x); }))};
}

} // namespace torrance::flip
