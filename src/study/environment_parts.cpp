#include "study/environment_parts.h"

#include "brdf/albedo.h"
#include "brdf/environment.h"
#include "brdf/lobe_albedo.h"
#include "math/powers.h"
#include "scene/phong.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace torrance {
namespace {

struct Lobe
{
    double scale, bias, diffuseWeight, E, EAverage;
};

Lobe lobeOf(const brdf::Preset& methods, double NoV, double perceptualRoughness, AlbedoSource albedos)
{
    const double mean = brdf::averageLobeAlbedo(perceptualRoughness);
    if (albedos == AlbedoSource::method)
        if (const auto* formula = std::get_if<brdf::DfgFormula>(&methods.dfg->formula)) {
            const dvec3 terms = (*formula)(NoV, perceptualRoughness);
            return {terms.x, terms.y, terms.z, terms.x + terms.y, mean};
        }
    const brdf::AlbedoTerms terms = brdf::ggxAlbedo(NoV, perceptualRoughness);
    return {terms.scale, terms.bias, brdf::schlickDiffuseWeight(NoV), terms.albedo(), mean};
}

dvec3 scattered(const brdf::Preset& methods, const Lobe& lobe, const dvec3& f0, const dvec3& once, const dvec3& spread)
{
    brdf::ShadingPoint point;
    point.f0 = f0;
    point.single = glm::max(once, dvec3(0.0));
    point.spread = spread;
    point.bias = lobe.bias;
    point.E = lobe.E;
    point.ELight = point.EAverage = lobe.EAverage;
    return std::get<brdf::ColorFormula>(methods.multipleScattering->formula)(point);
}

/// Means of (1 - VoH)^5 and (1 - NoL)^5 over what arrives.
struct SchlickMeans
{
    dvec3 atVoH, atNoL;
};

SchlickMeans schlickMeans(const brdf::EnvironmentQuery& query)
{
    const auto arriving = [&](const std::function<double(const dvec3&)>& weight) {
        brdf::EnvironmentQuery weighted = query;
        weighted.radiance = [&](const dvec3& l) { return query.radiance(l) * weight(l); };
        return brdf::Ed_irradiance_cube(weighted);
    };
    // Of black light any mean is right.
    const dvec3 all = glm::max(brdf::Ed_irradiance_cube(query), dvec3(std::numeric_limits<double>::min()));
    return {arriving([&](const dvec3& l) { return fifthPower(1.0 - 0.5 * glm::length(query.v + l)); }) / all,
            arriving([&](const dvec3& l) { return fifthPower(1.0 - glm::dot(query.n, l)); }) / all};
}

/// Share of the irradiance that the interface leaves to the body.
dvec3 bodyWeight(const brdf::Preset& methods, const Lobe& lobe, double f0, double NoV, const SchlickMeans& means)
{
    brdf::ShadingPoint point;
    const auto schlick = [&](const dvec3& w) { return f0 + (1.0 - f0) * w; };
    point.F = schlick(means.atVoH);
    point.FNoV = schlick(dvec3(fifthPower(1.0 - NoV)));
    point.FNoL = schlick(means.atNoL);
    point.lobeAlbedo = scattered(methods, lobe, dvec3(f0), dvec3(f0 * lobe.scale + lobe.bias), dvec3(1.0));
    return std::get<brdf::ColorFormula>(methods.diffuseWeight->formula)(point);
}

} // namespace

EnvironmentParts environmentParts(const Settings& settings, const EnvironmentSampler& environment,
                                  const MaterialPoint& material, const dvec3& view, AlbedoSource albedos)
{
    const brdf::Preset& methods = settings.methods;
    brdf::EnvironmentQuery query;
    query.radiance = [&](const dvec3& direction) { return environment.at(direction).radiance; };
    query.n = material.normal;
    query.v = view;
    query.perceptualRoughness = material.perceptualRoughness;
    query.samples = settings.environmentSamples;
    const double NoV = std::clamp(glm::dot(material.normal, view), 0.0, 1.0);
    const Lobe exact = lobeOf(methods, NoV, material.perceptualRoughness, AlbedoSource::exact);
    const Lobe lobe = lobeOf(methods, NoV, material.perceptualRoughness, albedos);
    const dvec3 irradiance = std::get<brdf::EnvironmentFormula>(methods.environmentDiffuse->formula)(query);
    const auto reflected = [&](const dvec3& f0) {
        query.f0 = f0;
        dvec3 once = std::get<brdf::EnvironmentFormula>(methods.environmentSpecular->formula)(query);
        if (!brdf::drawsSamples(*methods.environmentSpecular)) // their formula has the exact albedos in it
            once *= (f0 * lobe.scale + lobe.bias) / (f0 * exact.scale + exact.bias);
        return scattered(methods, lobe, f0, once, irradiance);
    };
    const double f0 = reflectanceOfIor(material.ior), m = material.metallic;
    EnvironmentParts parts;
    parts.lobe = material.occlusion * (reflected(dvec3(f0)) * (1.0 - m) + reflected(material.baseColor) * m);
    // Over even light the means are those of the table, and that of the cosine's directions. Points know those of
    // lamps, and what is left is gentle.
    const SchlickMeans means = brdf::hasLampPoints(*methods.environmentSpecular)
                                   ? schlickMeans(query)
                                   : SchlickMeans{dvec3(lobe.diffuseWeight), dvec3(1.0 / 21.0)};
    parts.body =
        material.occlusion * (1.0 - m) * irradiance * material.baseColor * bodyWeight(methods, lobe, f0, NoV, means);
    return parts;
}

} // namespace torrance
