#include "reference/shade.h"

#include "brdf/albedo.h"
#include "brdf/brdf.h"
#include "brdf/lobe_albedo.h"
#include "core/error.h"
#include "math/powers.h"
#include "scene/phong.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace torrance {
namespace {

void requireClosedForm(const brdf::Preset& preset)
{
    if (!brdf::isComposed(preset))
        throw usageError("the exact light of a uniform environment is not known for the preset " +
                             std::string(preset.id),
                         "use gltf or standard, or leave out the environment");
    const auto require = [](const brdf::Method* method, std::string_view id) {
        if (method->id != id)
            throw usageError("the exact light of a uniform environment is not known for " + std::string(method->id),
                             "use " + std::string(id));
    };
    require(preset.distribution, "ggx");
    require(preset.visibility, "smith_corr");
    require(preset.fresnel, "schlick");
    require(preset.diffuse, "lambert");
}

/// What the lobe returns of uniform light, multiple scattering included.
dvec3 furnaceLobe(const brdf::Method& method, const brdf::AlbedoTerms& terms, double perceptualRoughness,
                  const dvec3& f0)
{
    const double E = terms.albedo();
    const dvec3 once = f0 * terms.scale + terms.bias;
    const dvec3 meanF = f0 + (1.0 - f0) / 21.0;
    if (method.id == "scale") // Turquin 2019, eq. 16, on the lobe that returns E where F = 1
        return once * (1.0 + f0 * (1.0 / E - 1.0));
    if (method.id == "kulla_conty") { // Kulla & Conty 2017, with the sum over bounces of Hill 2018
        const double mean = brdf::averageLobeAlbedo(perceptualRoughness);
        return once + (1.0 - E) * meanF * meanF * mean / (1.0 - meanF * (1.0 - mean));
    }
    if (method.id == "fdez_aguera") // Fdez-Aguera 2019: F_ms E_ms
        return once + (1.0 - E) * once * meanF / (1.0 - meanF * (1.0 - E));
    return once;
}

/// The share of uniform light that the dielectric's interface leaves to a Lambertian body; `lobe` is what it reflects.
double furnaceWeight(const brdf::Method& method, double f0, double NoV, double lobe)
{
    if (method.id == "albedo_scaling")
        return 1.0 - lobe;
    if (method.id == "fresnel_nol_nov") // Schlick's term, and its mean over the light directions
        return (1.0 - f0) * (1.0 - fifthPower(1.0 - NoV)) * (1.0 - f0) * (1.0 - 1.0 / 21.0);
    return (1.0 - f0) * (1.0 - brdf::schlickDiffuseWeight(NoV));
}

} // namespace

dvec3 shadePunctual(const brdf::Preset& preset, const MaterialPoint& material, const dvec3& view,
                    const LightSample& light)
{
    if (light.irradiance == dvec3(0.0))
        return dvec3(0.0);
    brdf::ShadingPoint point =
        brdf::makeShadingPoint(material.normal, view, light.direction, material.perceptualRoughness);
    point.baseColor = material.baseColor;
    point.metallic = material.metallic;
    point.ior = material.ior;
    return brdf::evaluateTerms(preset, point).response() * light.irradiance;
}

dvec3 shadeFurnace(const brdf::Preset& preset, const MaterialPoint& material, const dvec3& view, const dvec3& radiance)
{
    requireClosedForm(preset);
    const double NoV = std::clamp(glm::dot(material.normal, view), 0.0, 1.0);
    const brdf::AlbedoTerms terms = brdf::ggxAlbedo(NoV, material.perceptualRoughness);
    const auto specular = [&](const dvec3& f0) {
        return furnaceLobe(*preset.multipleScattering, terms, material.perceptualRoughness, f0);
    };
    const double f0 = reflectanceOfIor(material.ior);
    const dvec3 reflected = specular(dvec3(f0));
    const dvec3 dielectric =
        material.baseColor * furnaceWeight(*preset.diffuseWeight, f0, NoV, reflected.r) + reflected;
    return radiance * (dielectric * (1.0 - material.metallic) + specular(material.baseColor) * material.metallic);
}

dvec3 shade(const brdf::Preset& preset, const Illumination& illumination, const MaterialPoint& material,
            const dvec3& origin, const dvec3& position, const dvec3& view)
{
    if (material.unlit)
        return material.baseColor;
    dvec3 radiance = material.emissive;
    for (const Light& light : illumination.lights)
        radiance += shadePunctual(preset, material, view, sampleLight(light, origin, position));
    if (illumination.uniformRadiance != dvec3(0.0))
        radiance += material.occlusion * shadeFurnace(preset, material, view, illumination.uniformRadiance);
    return radiance;
}

std::optional<dvec3> uniformRadiance(const Environment& environment)
{
    const Image& image = environment.radiance;
    if (image.texels.empty())
        return std::nullopt;
    const std::size_t channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = channels; i < image.texels.size(); ++i)
        if (image.texels[i] != image.texels[i % channels])
            return std::nullopt;
    return environment.intensity * dvec3(image.texels[0], image.texels[1], image.texels[2]);
}

} // namespace torrance
