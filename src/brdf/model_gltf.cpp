#include "brdf/brdf.h"
#include "brdf/lobe_albedo.h"
#include "brdf/lobe_albedo_table.h"
#include "brdf/model.h"
#include "scene/phong.h"

#include <algorithm>

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

// V without its denominator. With the light at the normal, and all else as it is, only the view is masked: for Smith's
// terms and for the V-cavity's this is their G1.
double maskingOfView(const Method& visibility, ShadingPoint point)
{
    point.NoL = 1.0;
    return scalar(visibility, point) * 4.0 * point.NoV;
}

// By quadrature that of the view takes ten thousand times as long as the rest: only what the methods read.
void setAlbedos(const Preset& preset, ShadingPoint& lobe)
{
    if (!preset.multipleScattering->readsAlbedo && !preset.diffuseWeight->readsAlbedo)
        return;
    const double r = lobe.perceptualRoughness;
    const double NoV = std::min(lobe.NoV, 1.0);
    const AlbedoTerms view = lobe.albedosOfTable ? lobeTermsFromTable(NoV, r) : lobeTerms(NoV, r);
    lobe.E = view.albedo();
    lobe.bias = view.bias;
    if (!preset.multipleScattering->readsLightAlbedo)
        return;
    // The light comes from another direction at each call. Both are of the table, so that v and l can be exchanged.
    lobe.E = lobeAlbedoFromTable(NoV, r);
    lobe.ELight = lobeAlbedoFromTable(std::min(lobe.NoL, 1.0), r);
    lobe.EAverage = averageLobeAlbedoFromTable(r);
}

// What lies over the body reflects: Fresnel's term by the facet and by the surface as a whole, and the lobe's albedo,
// multiple scattering included.
void setInterfaceOfBody(const Preset& preset, const dvec3& F, ShadingPoint& lobe)
{
    const auto fresnelAt = [&](double cosine) {
        ShadingPoint flat = lobe;
        flat.VoH = cosine;
        flat.oneLessVoH = 1.0 - cosine;
        return color(*preset.fresnel, flat);
    };
    ShadingPoint whole = lobe;
    whole.single = lobe.f0 * (lobe.E - lobe.bias) + lobe.bias;
    whole.spread = dvec3(1);
    whole.ELight = lobe.EAverage;
    lobe.F = F;
    lobe.FNoV = fresnelAt(std::min(lobe.NoV, 1.0));
    lobe.FNoL = fresnelAt(std::min(lobe.NoL, 1.0));
    lobe.lobeAlbedo = color(*preset.multipleScattering, whole);
}

} // namespace

BrdfTerms model_gltf(const Preset& preset, const ShadingPoint& point)
{
    BrdfTerms terms;
    if (point.NoV <= 0 || point.NoL <= 0)
        return terms;

    ShadingPoint lobe = point;
    lobe.f90 = dvec3(1);
    lobe.f82 = dvec3(1);
    lobe.alphaT = lobe.alphaB = lobe.alpha;
    setAlbedos(preset, lobe);
    terms.h = glm::normalize(point.v + point.l);
    terms.D = scalar(*preset.distribution, lobe);
    terms.V = scalar(*preset.visibility, lobe);
    terms.G = terms.V * 4.0 * point.NoV * point.NoL;
    terms.G1 = maskingOfView(*preset.visibility, lobe);
    const double specular = terms.D * terms.V;

    // Appendix B: metal_brdf = specular * F(base colour)
    lobe.f0 = point.baseColor;
    const dvec3 metalF = color(*preset.fresnel, lobe);
    lobe.single = specular * metalF;
    const dvec3 metal = color(*preset.multipleScattering, lobe);

    // Appendix B: dielectric_brdf = fresnel_mix(1.5, diffuse, specular); KHR_materials_ior in place of 1.5
    const dvec3 dielectricF0(reflectanceOfIor(point.ior));
    lobe.f0 = dielectricF0;
    const dvec3 F = color(*preset.fresnel, lobe);
    lobe.single = specular * F;
    const dvec3 reflected = color(*preset.multipleScattering, lobe);
    setInterfaceOfBody(preset, F, lobe);
    const dvec3 body = color(*preset.diffuse, lobe) * color(*preset.diffuseWeight, lobe);

    const double m = point.metallic;
    terms.F0 = dielectricF0 * (1.0 - m) + point.baseColor * m;
    terms.F = F * (1.0 - m) + metalF * m;
    terms.specular = reflected * (1.0 - m) + metal * m;
    terms.diffuse = body * (1.0 - m);
    terms.brdf = (body + reflected) * (1.0 - m) + metal * m;
    terms.weight = point.NoL;
    return terms;
}

} // namespace torrance::brdf
