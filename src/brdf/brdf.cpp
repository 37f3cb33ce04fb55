#include "brdf/brdf.h"

#include "brdf/dfg.h"
#include "core/error.h"

namespace torrance::brdf {
namespace {

double scalar(const Method& method, const ShadingPoint& point)
{
    return std::get<ScalarFormula>(method.formula)(point);
}

dvec3 color(const Method& method, const ShadingPoint& point)
{
    return std::get<ColorFormula>(method.formula)(point);
}

} // namespace

void requireWholeBrdf(const Preset& preset)
{
    if (preset.fresnel->id != "schlick")
        throw usageError("the glTF material cannot be shaded with the Fresnel term " + std::string(preset.fresnel->id) +
                             ", which needs an index of refraction that a base colour does not give",
                         "use --fresnel schlick");
}

dvec3 evaluateBrdf(const Preset& preset, const ShadingPoint& point)
{
    requireWholeBrdf(preset);
    if (point.NoV <= 0 || point.NoL <= 0)
        return dvec3(0);

    ShadingPoint lobe = point;
    lobe.f90 = dvec3(1);
    if (preset.multipleScattering->id != "none")
        lobe.E = lobeAlbedo(point.NoV, point.perceptualRoughness);
    const double specular = scalar(*preset.distribution, lobe) * scalar(*preset.visibility, lobe);

    // Appendix B: metal_brdf = specular * F(base colour)
    lobe.f0 = point.baseColor;
    const dvec3 metal = specular * color(*preset.fresnel, lobe) * color(*preset.multipleScattering, lobe);

    // Appendix B: dielectric_brdf = fresnel_mix(1.5, diffuse, specular)
    lobe.f0 = dvec3(kDielectricF0);
    const dvec3 F = color(*preset.fresnel, lobe);
    const dvec3 reflected = specular * F * color(*preset.multipleScattering, lobe);
    const dvec3 dielectric = color(*preset.diffuse, lobe) * (dvec3(1) - F) + reflected;

    return dielectric * (1.0 - point.metallic) + metal * point.metallic;
}

} // namespace torrance::brdf
