#include "reference/light_integral.h"

#include "math/frame.h"
#include "math/sampling.h"
#include "reference/reflected_importance.h"

#include <algorithm>

namespace torrance {

LightIntegral::LightIntegral(const Yardstick& yardstick, const Source& source, const MaterialPoint& material,
                             const dvec3& v, DirectionChoice choice, ResponsePart part)
    : incoming(incomingOf(source, material, v, choice)), shares(sharesOf(choice)),
      // Occlusion stands for what hides indirect light (glTF 2.0, 3.9.3).
      openness(std::holds_alternative<Surroundings>(incoming) ? material.occlusion : 1.0),
      worldFromLocal(frameAround(material.normal)), view(v * worldFromLocal),
      alpha(std::max(material.perceptualRoughness * material.perceptualRoughness, brdf::kMinAlpha)),
      reflectance(yardstick, material, view, part)
{
}

LightIntegral::Incoming LightIntegral::incomingOf(const Source& source, const MaterialPoint& material,
                                                  const dvec3& view, DirectionChoice choice)
{
    if (const auto* sphere = std::get_if<SphereLight>(&source))
        return *sphere;
    if (const auto* sample = std::get_if<LightSample>(&source))
        return Beam{*sample};
    const EnvironmentSampler* environment = std::get<const EnvironmentSampler*>(source);
    if (choice == DirectionChoice::combined) {
        auto distribution = environment->weighed(reflectedImportance(environment->tiles(), material, view));
        if (distribution.usable())
            return Surroundings{environment, std::move(distribution)};
    } // no light from above the surface, or no directions of the surface's are asked for
    return Surroundings{environment, environment->plain()};
}

std::vector<LightIntegral::Share> LightIntegral::sharesOf(DirectionChoice choice) const
{
    using enum Density;
    if (choice == DirectionChoice::light || std::holds_alternative<Beam>(incoming))
        return {{light, 4}};
    if (choice == DirectionChoice::brdf)
        return {{lobe, 2}, {cosine, 2}};
    if (std::holds_alternative<Surroundings>(incoming))
        return {{light, 3}, {lobe, 1}}; // the light's density knows the body
    return {{light, 2}, {lobe, 1}, {cosine, 1}};
}

dvec3 LightIntegral::draw(Density from, const dvec2& u) const
{
    switch (from) {
    case Density::light:
        return std::visit([&](const auto& l) { return l.draw(u); }, incoming) * worldFromLocal;
    case Density::lobe:
        return sampleGgxReflection(view, alpha, u);
    case Density::cosine:
        break;
    }
    return sampleCosine(u);
}

double LightIntegral::density(Density of, const dvec3& l, const DirectedLight& arriving) const
{
    switch (of) {
    case Density::light:
        return arriving.density;
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
    const dvec3 direction = worldFromLocal * l;
    const DirectedLight arriving = std::visit([&](const auto& from) { return from.at(direction); }, incoming);
    if (arriving.radiance == dvec3(0.0))
        return dvec3(0.0);
    double mean = 0.0;
    for (const Share& share : shares)
        mean += share.perTurn * density(share.density, l, arriving) / kDirectionsPerTurn;
    if (!(mean > 0.0)) // a drawn direction has a density; on the edge of its support rounding may say otherwise
        return dvec3(0.0);
    return reflectance(l, key) * arriving.radiance * (openness / mean);
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
