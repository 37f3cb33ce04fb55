#include "brdf/model_environment.h"

#include "brdf/environment.h"
#include "brdf/integration_map.h"
#include "brdf/method.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

EnvironmentQuery queryAt(double NoV, double r)
{
    EnvironmentQuery query;
    query.n = glm::normalize(dvec3(0.3, -0.5, 0.6));
    const dvec3 t = glm::normalize(glm::cross(query.n, dvec3(0, 1, 0)));
    query.v = query.n * NoV + t * std::sqrt(1 - NoV * NoV);
    query.perceptualRoughness = r;
    query.radiance = [](const dvec3&) { return dvec3(1); };
    return query;
}

// Light of radiance 1: reflectivity 0 is Lambert alone, a metal returns R0 = 1 times its colour at every angle, a
// dielectric F + (1 - F) c.
TEST(SourceEnvironment, OfEvenLightIsTheMixtureOfSourceE)
{
    Preset preset = *findPreset("torrance-sparrow-blinn");
    const EnvironmentQuery query = queryAt(0.3, 0.5);
    const dvec3 c(0.9, 0.5, 0.1);
    const auto returned = [&](double metalness) {
        return environment_torrance_sparrow_blinn(preset, query, c, metalness);
    };
    const double F = 0.04 + 0.96 * std::pow(0.7, 5);
    EXPECT_LE(glm::length(returned(1.0) - c), 1e-12);
    EXPECT_LE(glm::length(returned(0.0) - (dvec3(F) + (1 - F) * c)), 1e-12);
    preset.options.reflectivity = 0.25;
    EXPECT_LE(glm::length(returned(0.0) - (0.25 * (dvec3(F) + (1 - F) * c) + 0.75 * c)), 1e-12);
    preset.options.reflectivity = 0.0;
    EXPECT_LE(glm::length(returned(1.0) - c), 1e-12);
}

// Light of radiance 1: f0 x + y of the lobe, (1 - m) c z of the body; the map is held to the model's integral by
// itself.
TEST(SourceEnvironment, OfEvenLightIsTheIntegrationMap)
{
    Preset preset = *findPreset("ggx-burley");
    const EnvironmentQuery query = queryAt(0.3, 0.7);
    const dvec3 c(0.9, 0.5, 0.1), map = integrationMap(0.3, 0.7);
    const auto returned = [&](double metalness) { return environment_ggx_burley(preset, query, c, metalness); };
    EXPECT_LE(glm::length(returned(1.0) - (c * map.x + map.y)), 1e-12);
    EXPECT_LE(glm::length(returned(0.0) - (0.5 * map.x + map.y + c * map.z)), 1e-12);
    EXPECT_LE(glm::length(returned(0.25) - ((dvec3(0.375) + 0.25 * c) * map.x + map.y + 0.75 * c * map.z)), 1e-12);
    preset.options.fresnelAtView = true; // f0 = c rises by 0.7^5 of what is left
    const dvec3 risen = c + (dvec3(1) - c) * std::pow(0.7, 5);
    EXPECT_LE(glm::length(returned(1.0) - (risen * map.x + map.y)), 1e-12);
}

// Light from the mirror's side alone: of five levels the last has roughness 0.8, whose lobe is narrower.
TEST(SourceEnvironment, OfFiveLevelsEndsAtRoughnessFourFifths)
{
    Preset preset = *findPreset("ggx-burley");
    EnvironmentQuery query = queryAt(0.8, 1.0);
    query.radiance = [&](const dvec3& d) { return dvec3(1 + glm::dot(d, mirrorDirection(query))); };
    const auto lightAt = [&](double r) {
        query.perceptualRoughness = r;
        const dvec3 map = integrationMap(0.8, r);
        return environment_ggx_burley(preset, query, dvec3(1), 1.0).r / (map.x + map.y);
    };
    const double six = lightAt(1.0);
    EXPECT_NEAR(six, 1.0 + 2.0 / 3.0, 1e-12) << "Lambert's mean cosine";
    preset.options.fiveLevels = true;
    EXPECT_NEAR(lightAt(1.0), lightAt(0.8), 1e-12);
    EXPECT_GT(lightAt(1.0), six + 0.01);
    EXPECT_NEAR(lightAt(0.5), (preset.options.fiveLevels = false, lightAt(0.5)), 1e-12);
}

/// phong's parts of a surface that is lit by `lit`, under light that says which way it came.
struct Mirrors
{
    Preset preset = *findPreset("phong");
    EnvironmentQuery query;

    explicit Mirrors(double NoV) : query(queryAt(NoV, 0.5))
    {
        query.radiance = [](const dvec3& d) { return dvec3(2) + d; };
    }
    dvec3 seen(const dvec3& lit) const { return environment_phong(preset, query, lit); }
};

// (1 - n.v)^2 of the mirror image; an exponent of 0 leaves the factor alone, a factor of 0 the light of the lamps.
TEST(SourceEnvironment, OfPhongMixesTheMirrorImageIn)
{
    Mirrors mirrors(0.4);
    const dvec3 lit(0.3, 0.2, 0.1), image = dvec3(2) + 0.8 * mirrors.query.n - mirrors.query.v;
    EXPECT_LE(glm::length(mirrors.seen(lit) - (0.64 * lit + 0.36 * image)), 1e-12);
    mirrors.preset.options.fresnelExponent = 0.0;
    EXPECT_LE(glm::length(mirrors.seen(lit) - image), 1e-12);
    mirrors.preset.options.reflection = 0.25;
    EXPECT_LE(glm::length(mirrors.seen(lit) - (0.75 * lit + 0.25 * image)), 1e-12);
    mirrors.preset.options.reflection = 0.0;
    EXPECT_LE(glm::length(mirrors.seen(lit) - lit), 1e-12);
}

// Snell: the sine of the refracted direction is 0.8 of the view's, on the other side of the surface and of the normal.
TEST(SourceEnvironment, OfPhongRefractsTheMap)
{
    for (const double NoV : {1.0, 0.6, 0.1}) {
        Mirrors mirrors(NoV);
        mirrors.preset.options.reflection = 0.0;
        mirrors.preset.options.refraction = 1.0;
        const dvec3 direction = mirrors.seen(dvec3(7)) - dvec3(2), n = mirrors.query.n, v = mirrors.query.v;
        EXPECT_NEAR(glm::length(direction), 1.0, 1e-12);
        EXPECT_NEAR(glm::dot(direction, n), -std::sqrt(1.0 - 0.64 * (1.0 - NoV * NoV)), 1e-12);
        EXPECT_LE(glm::length(glm::cross(n, direction) + 0.8 * glm::cross(n, v)), 1e-12);
        mirrors.preset.options.refraction = 0.5;
        EXPECT_LE(glm::length(mirrors.seen(dvec3(7)) - 0.5 * (dvec3(9) + direction)), 1e-12);
    }
}

// Where all images are alike, mixing in one of them changes nothing: shares add up to 1.
TEST(SourceEnvironment, OfPhongAddsNoLight)
{
    Mirrors mirrors(0.2);
    mirrors.query.radiance = [](const dvec3&) { return dvec3(0.7); };
    mirrors.preset.options.refraction = 0.3;
    EXPECT_LE(glm::length(mirrors.seen(dvec3(0.7)) - dvec3(0.7)), 1e-15);
}

} // namespace
} // namespace torrance::brdf
