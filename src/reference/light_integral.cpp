#include "reference/light_integral.h"

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

/// One direction: its radiance over its density is the irradiance of a surface that faces the light.
struct Beam
{
    const LightSample& light;

    dvec3 draw(const dvec2&) const { return light.direction; }
    DirectedLight at(const dvec3&) const { return {light.irradiance, 1.0}; }
};

Beam sampler(const LightSample& light)
{
    return {light};
}

} // namespace

LightIntegral::LightIntegral(const Yardstick& yardstick, Source s, const MaterialPoint& material, const dvec3& v,
                             DirectionChoice choice, ResponsePart part)
    : source(std::move(s)), shares(sharesOf(choice)),
      // Occlusion stands for what hides indirect light (glTF 2.0, 3.9.3).
      openness(std::holds_alternative<const EnvironmentSampler*>(source) ? material.occlusion : 1.0),
      worldFromLocal(frameAround(material.normal)), view(v * worldFromLocal),
      alpha(std::max(material.perceptualRoughness * material.perceptualRoughness, brdf::kMinAlpha)),
      reflectance(yardstick, material, view, part)
{
}

std::vector<LightIntegral::Share> LightIntegral::sharesOf(DirectionChoice choice) const
{
    using enum Density;
    if (choice == DirectionChoice::light || std::holds_alternative<LightSample>(source))
        return {{light, 4}};
    if (choice == DirectionChoice::brdf)
        return {{lobe, 2}, {cosine, 2}};
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

dvec3 LightIntegral::contribution(const dvec3& l, std::uint64_t key) const
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
    return reflectance(l, key) * light.radiance * (openness / mean);
}

dvec3 LightIntegral::sumOfTurns(std::uint64_t key, std::uint32_t first, std::uint32_t turns) const
{
    dvec3 sum(0.0);
    for (const Share& share : shares) {
        const std::uint64_t sequence = hashNumbers({key, static_cast<std::uint64_t>(share.density)});
        const ScrambledSequence points(sequence);
        for (std::uint32_t i = first * share.perTurn; i < (first + turns) * share.perTurn; ++i)
            sum += contribution(draw(share.density, points[i]), hashNumbers({sequence, i}));
    }
    return sum;
}

} // namespace torrance
