// The light of one source that one surface point reflects, as a mean over drawn directions.
#pragma once

#include "math/scrambled_sequence.h"
#include "reference/environment_sampler.h"
#include "reference/punctual_light.h"
#include "reference/reflectance.h"
#include "reference/sphere_light.h"

#include <variant>
#include <vector>

namespace torrance {

/// From which densities directions are drawn. Each by itself gives the same integral: that they agree is a test of all.
enum class DirectionChoice
{
    combined, // all below together
    brdf,     // visible normals of the specular lobe, and the cosine
    light,    // the environment's brightness alone, the sphere's solid angle
};

/// Directions are drawn in turns, because only whole turns hold each density's exact share.
inline constexpr std::uint32_t kDirectionsPerTurn = 4;

/// A turn of `combined` takes three directions from an environment, by its brightness times about what the surface does
/// with it (reflected_importance.h), and one from the lobe (bounded visible normals, Eto & Tokuyoshi 2023); of a
/// sphere, two from it, one from the lobe and one from the cosine. A turn of `brdf` takes two from the lobe and two
/// from the cosine. A direction counts f(v, l) L(l) NoL over the mean density of the turn: the balance heuristic (Veach
/// & Guibas, Optimally Combining Sampling Techniques for Monte Carlo Rendering, 1995, section 3.2). No density need
/// match the BRDF: any method converges.
class LightIntegral
{
public:
    /// A punctual light has one direction, which every draw takes; the mean is over what the surface does with it.
    using Source = std::variant<const EnvironmentSampler*, SphereLight, LightSample>;

    /// Keeps references. An environment is not dark; `view` is unit, in the world.
    LightIntegral(const Yardstick& yardstick, const Source& source, const MaterialPoint& material, const dvec3& view,
                  DirectionChoice choice, ResponsePart part = ResponsePart::whole);

    /// The sum of what the directions of turns [first, first + turns) of the sequences of `key` contribute. The
    /// integral is the sum over their number. Occlusion takes its part of an environment's light.
    dvec3 sumOfTurns(std::uint64_t key, std::uint32_t first, std::uint32_t turns) const;

private:
    struct Surroundings
    {
        const EnvironmentSampler* environment;
        EnvironmentSampler::Distribution distribution;

        dvec3 draw(const dvec2& u) const { return environment->draw(u, distribution); }
        DirectedLight at(const dvec3& l) const { return environment->at(l, distribution); }
    };
    /// One direction: its radiance over its density is the irradiance of a surface that faces the light.
    struct Beam
    {
        LightSample light;

        dvec3 draw(const dvec2&) const { return light.direction; }
        DirectedLight at(const dvec3&) const { return {light.irradiance, 1.0}; }
    };
    using Incoming = std::variant<Surroundings, SphereLight, Beam>;
    static Incoming incomingOf(const Source& source, const MaterialPoint& material, const dvec3& view,
                               DirectionChoice choice);

    enum class Density
    {
        light,
        lobe,
        cosine,
    };
    struct Share
    {
        Density density;
        std::uint32_t perTurn;
    };
    std::vector<Share> sharesOf(DirectionChoice choice) const;
    dvec3 draw(Density from, const dvec2& u) const;
    double density(Density of, const dvec3& l, const DirectedLight& arriving) const;
    dvec3 contribution(const dvec3& l, std::uint64_t key) const;

    Incoming incoming;
    std::vector<Share> shares;
    double openness;      // share of the light that occlusion leaves
    dmat3 worldFromLocal; // local: the normal is +Z
    dvec3 view;           // local
    dvec2 alpha;
    Reflectance reflectance;
};

} // namespace torrance
