#include "reference/bounce_directions.h"

#include "brdf/shading_point.h"
#include "math/powers.h"
#include "math/sampling.h"
#include "scene/phong.h"

#include <algorithm>

namespace torrance {
namespace {

double brightest(const dvec3& color)
{
    return std::max({color.r, color.g, color.b});
}

/// Schlick's reflectance at the view against what is left to the body.
double lobeShareOf(const MaterialPoint& material, double NoV)
{
    const double f0 = std::lerp(reflectanceOfIor(material.ior), brightest(material.baseColor), material.metallic);
    const double lobe = f0 + (1.0 - f0) * fifthPower(1.0 - std::clamp(NoV, 0.0, 1.0));
    const double body = (1.0 - material.metallic) * brightest(material.baseColor) * (1.0 - lobe);
    const double share = lobe + body > 0.0 ? lobe / (lobe + body) : 0.5;
    return std::clamp(share, kLeastShare, 1.0 - kLeastShare);
}

} // namespace

BounceDirections::BounceDirections(const MaterialPoint& material, const dvec3& v)
    : view(v), alpha(std::max(material.perceptualRoughness * material.perceptualRoughness, brdf::kMinAlpha)),
      lobeShare(lobeShareOf(material, v.z))
{
}

dvec3 BounceDirections::draw(const dvec2& u) const
{
    if (u.x < lobeShare)
        return sampleGgxReflection(view, alpha, {u.x / lobeShare, u.y});
    return sampleCosine({(u.x - lobeShare) / (1.0 - lobeShare), u.y});
}

double BounceDirections::density(const dvec3& l) const
{
    return lobeShare * ggxReflectionDensity(view, alpha, l) + (1.0 - lobeShare) * cosineDensity(l);
}

} // namespace torrance
