#include "brdf/shading_point.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {
namespace {

// Squares of what lies between are far from the ends of double.
constexpr double kLeastPlain = 0x1p-500, kGreatestPlain = 0x1p500;

// Other vectors are scaled by a power of two first, which rounds nothing: squares of 1e200 or 1e-200 are no doubles.
dvec3 unit(const dvec3& vector)
{
    const double greatest = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
    if (greatest > kLeastPlain && greatest < kGreatestPlain)
        return glm::normalize(vector);
    int exponent = 0;
    std::frexp(greatest, &exponent);
    return glm::normalize(
        dvec3(std::ldexp(vector.x, -exponent), std::ldexp(vector.y, -exponent), std::ldexp(vector.z, -exponent)));
}

// Any direction in the surface: across that axis which the normal is farthest from.
dvec3 someTangent(const dvec3& n)
{
    return std::abs(n.x) <= std::abs(n.y) && std::abs(n.x) <= std::abs(n.z) ? dvec3(1, 0, 0)
           : std::abs(n.y) <= std::abs(n.z)                                 ? dvec3(0, 1, 0)
                                                                            : dvec3(0, 0, 1);
}

} // namespace

ShadingPoint makeShadingPoint(const dvec3& n, const dvec3& v, const dvec3& l, double perceptualRoughness)
{
    ShadingPoint point;
    point.n = unit(n);
    point.v = unit(v);
    point.l = unit(l);
    point.NoV = glm::dot(point.n, point.v);
    point.NoL = glm::dot(point.n, point.l);
    point.VoL = glm::dot(point.v, point.l);

    // The half vector is not normalised first: its length is 2 v.h, and n x t keeps the digits that 1 - NoH^2 would
    // cancel.
    // So does |v - l| for 1 - VoH, whose fifth power is all that a black metal reflects.
    const dvec3 t = point.v + point.l;
    const dvec3 d = point.v - point.l;
    const double length2 = glm::dot(t, t);
    if (length2 > 0) {
        const dvec3 nxt = glm::cross(point.n, t);
        point.NoH = glm::dot(point.n, t) / std::sqrt(length2);
        point.VoH = std::min(1.0, 0.5 * std::sqrt(length2));
        point.sin2H = std::min(1.0, glm::dot(nxt, nxt) / length2);
    } else {
        point.NoH = 0;
        point.VoH = 0;
        point.sin2H = 1;
    }
    point.oneLessVoH = 0.25 * glm::dot(d, d) / (1.0 + point.VoH);

    point.perceptualRoughness = perceptualRoughness;
    point.alpha = std::max(perceptualRoughness * perceptualRoughness, kMinAlpha);
    setAnisotropy(point, someTangent(point.n), 0.0);
    return point;
}

void setAnisotropy(ShadingPoint& point, const dvec3& tangent, double anisotropy)
{
    const dvec3 bitangent = unit(glm::cross(point.n, unit(tangent)));
    point.tangent = glm::cross(bitangent, point.n);
    point.anisotropy = anisotropy;
    point.alphaT = point.alpha + (1.0 - point.alpha) * anisotropy * anisotropy;
    point.alphaB = point.alpha;

    const dvec3 t = point.v + point.l;
    const double length = glm::length(t);
    point.ToH = length > 0 ? glm::dot(point.tangent, t) / length : 1.0;
    point.BoH = length > 0 ? glm::dot(bitangent, t) / length : 0.0;
}

} // namespace torrance::brdf
