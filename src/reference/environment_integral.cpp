#include "reference/environment_integral.h"

#include "brdf/brdf.h"
#include "math/frame.h"
#include "math/sampling.h"

#include <algorithm>

namespace torrance {

EnvironmentIntegral::EnvironmentIntegral(const brdf::Preset& p, const EnvironmentSampler& e, const MaterialPoint& m,
                                         const dvec3& v, DirectionChoice choice)
    : preset(p), environment(e), shares(sharesOf(choice)), material(m), worldFromLocal(frameAround(m.normal)),
      view(v * worldFromLocal), alpha(std::max(m.perceptualRoughness * m.perceptualRoughness, brdf::kMinAlpha))
{
}

std::vector<EnvironmentIntegral::Share> EnvironmentIntegral::sharesOf(DirectionChoice choice)
{
    using enum Density;
    switch (choice) {
    case DirectionChoice::environment:
        return {{Density::environment, 4}};
    case DirectionChoice::brdf:
        return {{lobe, 2}, {cosine, 2}};
    case DirectionChoice::combined:
        break;
    }
    return {{Density::environment, 2}, {lobe, 1}, {cosine, 1}};
}

dvec3 EnvironmentIntegral::draw(Density from, const dvec2& u) const
{
    switch (from) {
    case Density::environment:
        return environment.draw(u) * worldFromLocal;
    case Density::lobe:
        return sampleGgxReflection(view, alpha, u);
    case Density::cosine:
        break;
    }
    return sampleCosine(u);
}

double EnvironmentIntegral::density(Density of, const dvec3& l, const EnvironmentSampler::Light& light) const
{
    switch (of) {
    case Density::environment:
        return light.density;
    case Density::lobe:
        return ggxReflectionDensity(view, alpha, l);
    case Density::cosine:
        break;
    }
    return cosineDensity(l);
}

dvec3 EnvironmentIntegral::contribution(const dvec3& l) const
{
    if (!(l.z > 0.0))
        return dvec3(0.0);
    const EnvironmentSampler::Light light = environment.at(worldFromLocal * l);
    double mean = 0.0;
    for (const Share& share : shares)
        mean += share.perTurn * density(share.density, l, light) / kDirectionsPerTurn;
    if (!(mean > 0.0)) // a drawn direction has a density; on the edge of its support rounding may say otherwise
        return dvec3(0.0);
    brdf::ShadingPoint point = brdf::makeShadingPoint(dvec3(0, 0, 1), view, l, material.perceptualRoughness);
    point.baseColor = material.baseColor;
    point.metallic = material.metallic;
    return brdf::evaluateBrdf(preset, point) * light.radiance * (material.occlusion * l.z / mean);
}

dvec3 EnvironmentIntegral::sumOfTurns(std::uint64_t key, std::uint32_t first, std::uint32_t turns) const
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
