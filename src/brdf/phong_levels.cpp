#include "brdf/phong_levels.h"

#include "brdf/environment.h"
#include "brdf/material_mapping.h"
#include "math/frame.h"
#include "math/powers.h"
#include "math/quadrature.h"
#include "scene/phong.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {
namespace {

constexpr int kNodes = 48; // of the polar angle; twice as many round the axis

// The lobe's share beyond the angle of cosine z is u = z^(s + 1), in which its weight is even; u = t^4 has no root at 0
// for Gauss' nodes to miss.
dvec3 lobeMean(const EnvironmentQuery& query, const dvec3& axis, double exponent)
{
    static const QuadratureRule rule = gaussLegendre(kNodes, 0.0, 1.0);
    const dmat3 axes = frameAround(axis);
    dvec3 sum(0);
    for (std::size_t i = 0; i < rule.size(); ++i) {
        const double t = rule.nodes[i], z = std::pow(t, 4.0 / (exponent + 1.0)), radius = std::sqrt(1.0 - z * z);
        dvec3 ring(0);
        for (int j = 0; j < 2 * kNodes; ++j) {
            const double phi = kPi * (j + 0.5) / kNodes;
            ring += query.radiance(axes * dvec3(radius * std::cos(phi), radius * std::sin(phi), z));
        }
        sum += rule.weights[i] * 4.0 * t * t * t / (2 * kNodes) * ring;
    }
    return sum;
}

dvec3 levelRadiance(const EnvironmentQuery& query, const dvec3& axis, int level)
{
    return level == 0 ? query.radiance(axis) : lobeMean(query, axis, phongLevelExponent(level));
}

} // namespace

double phongLevelExponent(int level)
{
    return shininessOfPerceptualRoughness(static_cast<double>(level) / (kPhongLevels - 1));
}

double phongLevel(double perceptualRoughness)
{
    return std::max(perceptualRoughness, std::sqrt(kMinAlpha)) * (kPhongLevels - 1);
}

dvec3 phongRadiance(const EnvironmentQuery& query)
{
    const double lod = phongLevel(query.perceptualRoughness);
    const int lower = std::min(static_cast<int>(lod), kPhongLevels - 2);
    const dvec3 axis = mirrorDirection(query);
    return glm::mix(levelRadiance(query, axis, lower), levelRadiance(query, axis, lower + 1), lod - lower);
}

dvec3 Es_phong_levels(const EnvironmentQuery& query)
{
    const dvec3 fresnel = query.f0 + (dvec3(1) - query.f0) * fifthPower(1.0 - glm::dot(query.n, query.v));
    return fresnel * phongRadiance(query);
}

} // namespace torrance::brdf
