#include "brdf/specular_antialiasing.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {

double AA_none(const NormalFootprint& footprint)
{
    return footprint.alpha;
}

double AA_toksvig(const NormalFootprint& footprint)
{
    const double L = footprint.meanLength;
    const double power = 2.0 / (footprint.alpha * footprint.alpha) - 2.0;
    const double factor = L / (L + power * (1.0 - L));
    return std::sqrt(2.0 / (factor * power + 2.0));
}

double AA_tokuyoshi(const NormalFootprint& footprint)
{
    const double turn2 = glm::dot(footprint.dndx, footprint.dndx) + glm::dot(footprint.dndy, footprint.dndy);
    const double variance = turn2 / (2.0 * kPi); // of a Gaussian pixel filter of variance 1 / (2 pi)
    return std::sqrt(std::min(footprint.alpha * footprint.alpha + std::min(2.0 * variance, kKernelCap), 1.0));
}

} // namespace torrance::brdf
