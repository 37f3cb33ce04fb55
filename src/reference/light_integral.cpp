#include "reference/light_integral.h"

#include "brdf/brdf.h"
#include "math/frame.h"
#include "math/sampling.h"

#include <algorithm>

namespace torrance {
namespace {

const EnvironmentSampler& sampler(const EnvironmentSampler* environment)
{
    return *environment;
}

const SphereLight& sampler(const SphereLight& sphere)
{
    return sphere;
}

/// Occlusion stands for what hides the environment (glTF 2.0, 3.9.3: indirect light).
double openness(const LightIntegral::Source& source, const MaterialPoint& material)
{
    return std::holds_alternative<SphereLight>(source) ? 1.0 : material.occlusion;
}

} // namespace

LightIntegral::LightIntegral(const brdf::Preset& p, Source s, const MaterialPoint& m, const dvec3& v,
                             DirectionChoice choice)
    : preset(p), source(std::move(s)), shares(sharesOf(choice)), material(m), worldFromLocal(frameAround(m.normal)),
      view(v * worldFromLocal), alpha(std::max(m.perceptualRoughness * m.perceptualRoughness, brdf::kMinAlpha))
{
}

std::vector<LightIntegral::Share> LightIntegral::sharesOf(DirectionChoice choice)
{
    using enum Density;
    switch (choice) {
    case DirectionChoice::light:
        return {{light, 4}};
    case DirectionChoice::brdf:
        return {{lobe, 2}, {cosine, 2}};
    case DirectionChoice::combined:
        break;
    }
    return {{light, 2}, {lobe, 1}, {cosine, 1}};
}

dvec3 LightIntegral::draw(Density from, const dvec2& u) const
{
    switch (from) {
    case Density::light:
        return std::visit([&](const auto& s) { return sampler(s).draw(u); }, source) * worldFromLocal;
    case Density::lobe:
        return sampleGgxReflection(view, alpha, u);
    case Density::cosine:
        break;
    }
    return sampleCosine(u);
}

double LightIntegral::density(Density of, const dvec3& l, const DirectedLight& light) const
{
    switch (of) {
    case Density::light:
        return light.density;
    case Density::lobe:
        return ggxReflectionDensity(view, alpha, l);
    case Density::cosine:
        break;
    }
    return cosineDensity(l);
}

dvec3 LightIntegral::contribution(const dvec3& l) const
{
    if (!(l.z > 0.0))
        return dvec3(0.0);
    const DirectedLight light = std::visit([&](const auto& s) { return sampler(s).at(worldFromLocal * l); }, source);
    if (light.radiance == dvec3(0.0))
        return dvec3(0.0);
    double mean = 0.0;
    for (const Share& share : shares)
        mean += share.perTurn * density(share.density, l, light) / kDirectionsPerTurn;
    if (!(mean > 0.0)) // a drawn direction has a density; on the edge of its support rounding may say otherwise
        return dvec3(0.0);
    brdf::ShadingPoint point = brdf::makeShadingPoint(dvec3(0, 0, 1), view, l, material.perceptualRoughness);
    point.baseColor = material.baseColor;
    point.metallic = material.metallic;
    return brdf::evaluateTerms(preset, point).response() * light.radiance * (openness(source, material) / mean);
}

dvec3 LightIntegral::sumOfTurns(std::uint64_t key, std::uint32_t first, std::uint32_t turns) const
{
    dvec3 sum(0.0);
    for (const Share& share : shares) {
        const ScrambledSequence points(hashNumbers({key, static_cast<std::uint64_t>(share.density)}));
        for (std::uint32_t i = first * share.perTurn; i < (first + turns) * share.perTurn; ++i)
            sum += contribution(draw(share.density, points[i]));
    }
    return sum;
}

} // namespace torrance
