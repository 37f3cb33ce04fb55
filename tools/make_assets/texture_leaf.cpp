#include "make_assets/noise.h"
#include "make_assets/textures.h"

#include <algorithm>
#include <cmath>

namespace torrance::assets {
namespace {

/// Half the leaf's width at a height t (0 root, 1 tip), where the picture is 1 wide.
double leafHalfWidth(double t)
{
    if (t <= 0.05 || t >= 0.98)
        return 0.012;
    const double s = (t - 0.05) / 0.93;
    return 0.47 * std::pow(std::sin(kPi * std::pow(s, 0.85)), 0.72);
}

/// 1 on a vein, 0 away from one: the midrib, and side veins that leave it upwards.
double veins(double across, double t)
{
    const double midrib = std::exp(-std::pow(across / (0.022 * (1.1 - t)), 2.0));
    const double phase = (t - 0.75 * std::abs(across)) * 11.0;
    const double side = std::exp(-std::pow((phase - std::round(phase)) / 0.07, 2.0)) * 0.45;
    return std::max(midrib, side);
}

} // namespace

Image leafColor(int size)
{
    return makePicture(size / 2, size, 4, [size](double u, double v) {
        const double across = u - 0.5;
        const double t = 1.0 - v;
        const double cloud = cloudNoise(u * 4, v * 8, 4, 8, 81);
        const dvec3 blade = glm::mix(dvec3(0.25, 0.37, 0.24), dvec3(0.44, 0.53, 0.36), 0.6 * t + 0.4 * cloud);
        const dvec3 color = glm::mix(blade, dvec3(0.66, 0.71, 0.52), 0.65 * veins(across, t));
        const double inside = leafHalfWidth(t) - std::abs(across);
        return dvec4(color, 0.5 + inside * size / 2.0 / 4.0);
    });
}

} // namespace torrance::assets
