#include "brdf/material_mapping.h"

#include "brdf/brdf.h"
#include "brdf/shading_point.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {
namespace {

constexpr double kExponentRatio = 4.0; // of n.h's to R.v's

} // namespace

double shininessOf(double perceptualRoughness)
{
    const double alpha = std::max(perceptualRoughness * perceptualRoughness, kMinAlpha);
    return 2.0 / (alpha * alpha) - 2.0;
}

double roughnessOfShininess(double shininess)
{
    const double alpha = std::sqrt(2.0 / (shininess + 2.0));
    return std::sqrt(std::max(alpha, kMinAlpha));
}

double glossinessOf(double perceptualRoughness)
{
    return shininessOf(perceptualRoughness) / kExponentRatio;
}

double roughnessOfGlossiness(double glossiness)
{
    return roughnessOfShininess(glossiness * kExponentRatio);
}

double r0Of(double metallic)
{
    return std::lerp(kDielectricF0, 1.0, metallic);
}

MetallicColor metallicOfR0(const dvec3& color, double metalness, double r0)
{
    return {.baseColor = glm::mix(color, color * r0, metalness), .metallic = metalness};
}

double reflectanceOfIndices(double n1, double n2)
{
    const double ratio = (n1 - n2) / (n1 + n2);
    return ratio * ratio;
}

} // namespace torrance::brdf
