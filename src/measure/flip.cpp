#include "measure/flip.h"

#include "core/parallel.h"
#include "measure/flip_color.h"
#include "measure/flip_filter.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

namespace torrance {
namespace {

using flip::Opponent;
using flip::Plane;
using Planes = std::array<Plane, 3>;

constexpr double kFeatureExponent = 0.5; // 2020, eq. 8
constexpr std::size_t kPixelGrain = 4096;

// The paper's tone curve (2021, section 3.1): Narkowicz's fit of ACES without its built-in exposure of 0.6.
constexpr double kPreExposure = 0.6;
constexpr double kAbove2 = kPreExposure * kPreExposure * 2.51, kAbove1 = kPreExposure * 0.03;
constexpr double kBelow2 = kPreExposure * kPreExposure * 2.43, kBelow1 = kPreExposure * 0.59, kBelow0 = 0.14;
constexpr double kShownWhite = 0.85; // what the brightest and the median pixel are shown at

Planes emptyPlanes(const Image& image)
{
    return {Plane(image.width, image.height), Plane(image.width, image.height), Plane(image.width, image.height)};
}

Planes opponentPlanes(const Image& linear)
{
    Planes planes = emptyPlanes(linear);
    parallelFor(planes[0].values.size(), kPixelGrain, [&](std::size_t i) {
        const float* texel = &linear.texels[3 * i];
        const dvec3 color = glm::clamp(dvec3(texel[0], texel[1], texel[2]), 0.0, 1.0);
        const dvec3 opponent = flip::opponentFromLinear(color);
        for (int channel = 0; channel < 3; ++channel)
            planes[static_cast<std::size_t>(channel)].values[i] = opponent[channel];
    });
    return planes;
}

Plane seen(const Plane& plane, Opponent channel, double pixelsPerDegree)
{
    Plane result(plane.width, plane.height);
    for (const flip::SensitivityTerm& term : flip::sensitivity(channel, pixelsPerDegree)) {
        const Plane blurred = flip::convolved(plane, term.kernel, term.kernel);
        for (std::size_t i = 0; i < result.values.size(); ++i)
            result.values[i] += term.share * blurred.values[i];
    }
    return result;
}

// What the eye resolves, as Hunt-adjusted CIELAB.
Planes seenColors(const Planes& opponent, double pixelsPerDegree)
{
    Planes planes = {seen(opponent[0], Opponent::achromatic, pixelsPerDegree),
                     seen(opponent[1], Opponent::redGreen, pixelsPerDegree),
                     seen(opponent[2], Opponent::blueYellow, pixelsPerDegree)};
    parallelFor(planes[0].values.size(), kPixelGrain, [&](std::size_t i) {
        const dvec3 linear = flip::linearFromOpponent({planes[0].values[i], planes[1].values[i], planes[2].values[i]});
        const dvec3 lab = flip::huntLab(glm::clamp(linear, 0.0, 1.0));
        for (int channel = 0; channel < 3; ++channel)
            planes[static_cast<std::size_t>(channel)].values[i] = lab[channel];
    });
    return planes;
}

struct Features
{
    std::vector<double> edge; // length of the response to edges and to points, per pixel
    std::vector<double> point;
};

std::vector<double> lengths(const Plane& x, const Plane& y)
{
    std::vector<double> result(x.values.size());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = std::hypot(x.values[i], y.values[i]);
    return result;
}

Features featuresOf(const Plane& achromatic, const flip::FeatureKernels& kernels)
{
    Plane grey = achromatic;
    for (double& value : grey.values)
        value = (value + 16.0) / 116.0; // luminance in [0, 1]
    return {.edge = lengths(flip::convolved(grey, kernels.edge, kernels.smooth),
                            flip::convolved(grey, kernels.smooth, kernels.edge)),
            .point = lengths(flip::convolved(grey, kernels.point, kernels.smooth),
                             flip::convolved(grey, kernels.smooth, kernels.point))};
}

float shown(float value, double gain)
{
    const double x = value > 0.0f ? static_cast<double>(value) * gain : 0.0;
    const double y = (kAbove2 * x + kAbove1) * x / ((kBelow2 * x + kBelow1) * x + kBelow0);
    return static_cast<float>(std::min(y, 1.0));
}

Image exposed(const Image& image, double stops)
{
    Image result = image;
    const double gain = std::exp2(stops);
    parallelFor(result.texels.size(), kPixelGrain,
                [&](std::size_t i) { result.texels[i] = shown(image.texels[i], gain); });
    return result;
}

// The positive root of curve(x) = kShownWhite.
double exposedToShownWhite()
{
    const double a = kAbove2 - kShownWhite * kBelow2, b = kAbove1 - kShownWhite * kBelow1, c = -kShownWhite * kBelow0;
    return (-b + std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
}

std::vector<double> positiveLuminances(const Image& image, std::size_t& dark)
{
    std::vector<double> luminances;
    for (std::size_t i = 0; i + 2 < image.texels.size(); i += 3) {
        const dvec3 color = glm::max(dvec3(image.texels[i], image.texels[i + 1], image.texels[i + 2]), 0.0);
        // Row Y of the matrix of flip_color.cpp.
        const double y = (2613072.0 * color.x + 8788810.0 * color.y + 887015.0 * color.z) / 12288897.0;
        if (y > 0.0)
            luminances.push_back(y);
    }
    dark = image.texels.size() / 3 - luminances.size();
    return luminances;
}

} // namespace

Image ldrFlip(const Image& reference, const Image& test, double pixelsPerDegree)
{
    assert(reference.channels == 3 && test.channels == 3);
    assert(reference.width == test.width && reference.height == test.height);
    const Planes opponentR = opponentPlanes(reference), opponentT = opponentPlanes(test);
    const flip::FeatureKernels kernels = flip::featureKernels(pixelsPerDegree);
    const Features featuresR = featuresOf(opponentR[0], kernels), featuresT = featuresOf(opponentT[0], kernels);
    const Planes labR = seenColors(opponentR, pixelsPerDegree), labT = seenColors(opponentT, pixelsPerDegree);
    Image result(reference.width, reference.height, 1);
    parallelFor(result.texels.size(), kPixelGrain, [&](std::size_t i) {
        const double color = flip::colorDifference({labR[0].values[i], labR[1].values[i], labR[2].values[i]},
                                                   {labT[0].values[i], labT[1].values[i], labT[2].values[i]});
        const double feature = std::max(std::abs(featuresR.edge[i] - featuresT.edge[i]),
                                        std::abs(featuresR.point[i] - featuresT.point[i]));
        // 2020, eq. 8 and 9: a difference of features makes one of colours count for more.
        result.texels[i] =
            static_cast<float>(std::pow(color, 1.0 - std::pow(feature / std::sqrt(2.0), kFeatureExponent)));
    });
    return result;
}

FlipExposures flipExposures(const Image& reference)
{
    std::size_t dark = 0;
    std::vector<double> luminances = positiveLuminances(reference, dark);
    if (luminances.empty())
        return {};
    const double largest = *std::max_element(luminances.begin(), luminances.end());
    // The upper median of all pixels, of which the dark ones come first; of the others where it is dark.
    const std::size_t middle = (luminances.size() + dark) / 2;
    const std::size_t place = middle >= dark ? middle - dark : luminances.size() / 2;
    std::nth_element(luminances.begin(), luminances.begin() + static_cast<std::ptrdiff_t>(place), luminances.end());
    const double white = exposedToShownWhite();
    FlipExposures exposures{
        .start = std::log2(white / largest), .stop = std::log2(white / luminances[place]), .count = 2};
    exposures.count = std::max(2, static_cast<int>(std::ceil(exposures.stop - exposures.start)));
    return exposures;
}

Image hdrFlip(const Image& reference, const Image& test, double pixelsPerDegree)
{
    const FlipExposures exposures = flipExposures(reference);
    Image result(reference.width, reference.height, 1);
    for (int i = 0; i < exposures.count; ++i) {
        const double step = exposures.count > 1 ? (exposures.stop - exposures.start) / (exposures.count - 1) : 0.0;
        const double stops = exposures.start + i * step;
        const Image flip = ldrFlip(exposed(reference, stops), exposed(test, stops), pixelsPerDegree);
        std::transform(flip.texels.begin(), flip.texels.end(), result.texels.begin(), result.texels.begin(),
                       [](float a, float b) { return std::max(a, b); });
    }
    return result;
}

} // namespace torrance
