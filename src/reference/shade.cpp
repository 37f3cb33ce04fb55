#include "reference/shade.h"

#include "brdf/albedo.h"
#include "brdf/brdf.h"
#include "core/error.h"

#include <algorithm>
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
    if (preset.multipleScattering->id != "none")
        require(preset.multipleScattering, "scale");
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
    return brdf::evaluateTerms(preset, point).response() * light.irradiance;
}

dvec3 shadeFurnace(const brdf::Preset& preset, const MaterialPoint& material, const dvec3& view, const dvec3& radiance)
{
    requireClosedForm(preset);
    const double NoV = std::clamp(glm::dot(material.normal, view), 0.0, 1.0);
    const brdf::AlbedoTerms terms = brdf::ggxAlbedo(NoV, material.perceptualRoughness);
    const bool compensated = preset.multipleScattering->id == "scale";
    const auto specular = [&](const dvec3& f0) {
        // Turquin 2019, eq. 16, on the lobe that returns E where F = 1
        const dvec3 factor = compensated ? 1.0 + f0 * (1.0 / terms.albedo() - 1.0) : dvec3(1.0);
        return factor * (f0 * terms.scale + terms.bias);
    };
    const dvec3 diffuse = material.baseColor * ((1.0 - brdf::kDielectricF0) * (1.0 - brdf::schlickDiffuseWeight(NoV)));
    const dvec3 dielectric = diffuse + specular(dvec3(brdf::kDielectricF0));
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
