#include "make_assets/noise.h"
#include "make_assets/textures.h"

#include <cmath>

namespace torrance::assets {
namespace {

/// How dark the wood is, 0 to 1: growth rings cut lengthwise, fibres and pores stretched along the grain.
double woodDarkness(double u, double v)
{
    const double drift = cloudNoise(u * 2, v * 3, 2, 3, 51) + 0.35 * cloudNoise(u * 4, v * 16, 4, 16, 52);
    const double ring = v * 7.0 + 3.2 * drift;
    const double saw = ring - std::floor(ring);
    // Early wood darkens slowly towards the late wood, which ends sharply.
    const double growth = saw < 0.86 ? std::pow(saw / 0.86, 2.2) : (1.0 - saw) / 0.14;
    const double fibre = cloudNoise(u * 8, v * 220, 8, 220, 53);
    const double pore = std::pow(smoothNoise(u * 24, v * 300, 24, 300, 54), 7.0);
    return glm::clamp(0.15 + 0.55 * growth + 0.35 * (fibre - 0.5) + 0.5 * pore, 0.0, 1.0);
}

} // namespace

Image woodColor(int size)
{
    return makePicture(size, size, 3, [](double u, double v) {
        const dvec3 light(0.70, 0.49, 0.32);
        const dvec3 dark(0.33, 0.195, 0.115);
        const double tone = 0.10 * (cloudNoise(u * 3, v * 5, 3, 5, 55) - 0.5);
        return dvec4(glm::mix(light, dark, woodDarkness(u, v)) * (1.0 + tone), 1.0);
    });
}

Image woodRoughness(int size)
{
    return makePicture(size, size, 3,
                       [](double u, double v) { return dvec4(0.0, 0.38 + 0.22 * woodDarkness(u, v), 0.0, 1.0); });
}

} // namespace torrance::assets
