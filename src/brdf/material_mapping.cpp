#include "brdf/material_mapping.h"

#include "brdf/brdf.h"
#include "brdf/shading_point.h"
#include "scene/phong.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {
namespace {

constexpr double kExponentRatio = 4.0; // of n.h's to R.v's

const double kLeastRoughness = std::sqrt(kMinAlpha);

} // namespace

double shininessOf(double perceptualRoughness)
{
    return shininessOfPerceptualRoughness(std::max(perceptualRoughness, kLeastRoughness));
}

double roughnessOfShininess(double shininess)
{
    return std::max(perceptualRoughnessOfShininess(shininess), kLeastRoughness);
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
