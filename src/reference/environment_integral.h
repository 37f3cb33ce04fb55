// The environment's light that one surface point reflects, as a mean over drawn directions.
#pragma once

#include "brdf/method.h"
#include "math/scrambled_sequence.h"
#include "reference/environment_sampler.h"
#include "reference/material_point.h"

namespace torrance {

/// From which densities directions are drawn. Each by itself gives the same integral: that they agree is a test of all.
enum class DirectionChoice
{
    combined,    // all below together
    brdf,        // visible normals of the specular lobe, and the cosine
    environment, // the environment's brightness
};

/// Directions are drawn in turns, because only whole turns hold each density's exact share.
inline constexpr std::uint32_t kDirectionsPerTurn = 4;

/// A turn of `combined` takes two directions from the environment, one from the lobe (bounded visible normals, Eto &
/// Tokuyoshi 2023) and one from the cosine; of `brdf`, two from the lobe and two from the cosine. A direction counts
/// f(v, l) L(l) NoL over the mean density of the turn: the balance heuristic (Veach & Guibas, Optimally Combining
/// Sampling Techniques for Monte Carlo Rendering, 1995, section 3.2). No density need match the BRDF: any method
/// converges.
class EnvironmentIntegral
{
public:
    /// Keeps references. The environment is not dark; `view` is unit, in the world.
    EnvironmentIntegral(const brdf::Preset& preset, const EnvironmentSampler& environment,
                        const MaterialPoint& material, const dvec3& view, DirectionChoice choice);

    /// The sum of what the directions of turns [first, first + turns) of the sequences of `key` contribute. The
    /// integral is the sum over their number. Occlusion is in it.
    dvec3 sumOfTurns(std::uint64_t key, std::uint32_t first, std::uint32_t turns) const;

private:
    enum class Density
    {
        environment,
        lobe,
        cosine,
    };
    struct Share
    {
        Density density;
        std::uint32_t perTurn;
    };
    static std::vector<Share> sharesOf(DirectionChoice choice);
    dvec3 draw(Density from, const dvec2& u) const;
    double density(Density of, const dvec3& l, const EnvironmentSampler::Light& light) const;
    dvec3 contribution(const dvec3& l) const;

    const brdf::Preset& preset;
    const EnvironmentSampler& environment;
    std::vector<Share> shares;
    MaterialPoint material;
    dmat3 worldFromLocal; // local: the normal is +Z
    dvec3 view;           // local
    dvec2 alpha;
};

} // namespace torrance
