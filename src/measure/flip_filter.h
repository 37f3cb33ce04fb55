// The filters of FLIP: what the eye blurs, and what it finds edges and points with.
#pragma once

#include <vector>

namespace torrance::flip {

/// One value per pixel, row after row.
struct Plane
{
    int width = 0;
    int height = 0;
    std::vector<double> values;

    Plane(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
    double* row(int y) { return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
    const double* row(int y) const { return const_cast<Plane*>(this)->row(y); }
};

/// Weights of a one-dimensional filter: 2 * radius + 1, the middle one for the pixel itself.
using Kernel = std::vector<double>;

/// Convolves with `alongX` and `alongY` in turn; the edge pixels go on for ever outside.
Plane convolved(const Plane& plane, const Kernel& alongX, const Kernel& alongY);

/// A Gaussian of a contrast sensitivity function: exp(-(pi x)^2 / b) with x in degrees, normalised to sum 1; and its
/// share of that function's sum of Gaussians a sqrt(pi / b) exp(-(pi x)^2 / b).
struct SensitivityTerm
{
    double share = 1.0;
    Kernel kernel;
};

enum class Opponent
{
    achromatic,
    redGreen,
    blueYellow,
};

/// 2020, table 1 and eq. 5. The shares sum to 1, so that a flat picture stays as it is.
std::vector<SensitivityTerm> sensitivity(Opponent channel, double pixelsPerDegree);

/// The Gaussian of the feature detectors, sum 1, and its first and second derivative, whose positive weights sum to 1
/// and negative ones to -1 (2020, section 4.2).
struct FeatureKernels
{
    Kernel smooth;
    Kernel edge;
    Kernel point;
};

FeatureKernels featureKernels(double pixelsPerDegree);

} // namespace torrance::flip
