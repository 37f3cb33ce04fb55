#include "study/environment_parts.h"

#include "brdf/albedo.h"
#include "math/frame.h"
#include "math/low_discrepancy.h"
#include "math/powers.h"
#include "math/sampling.h"
#include "scene/phong.h"
#include "tests/panorama_of.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

const dvec3 kNormal(0.0, 1.0, 0.0), kView = glm::normalize(dvec3(0.0, 0.4, 1.0));

// White, dielectric, by a preset whose interface depends on VoH.
double bodyBy(const char* specular, const EnvironmentSampler& environment)
{
    Settings settings = {.methods = *brdf::findPreset("gltf")};
    settings.methods[brdf::Slot::environmentSpecular] = brdf::findMethod(brdf::Slot::environmentSpecular, specular);
    MaterialPoint material;
    material.metallic = 0.0;
    material.normal = kNormal;
    return environmentParts(settings, environment, material, kView, AlbedoSource::exact).body.g;
}

double bodyExactly(const EnvironmentSampler& environment)
{
    constexpr std::uint32_t kDirections = 1 << 16;
    const double f0 = reflectanceOfIor(MaterialPoint().ior);
    double sum = 0.0;
    for (std::uint32_t i = 0; i < kDirections; ++i) {
        const dvec3 l = frameAround(kNormal) * sampleCosine(hammersley(i, kDirections));
        const double VoH = 0.5 * glm::length(kView + l);
        sum += environment.at(l).radiance.g * (1.0 - f0) * (1.0 - fifthPower(1.0 - VoH));
    }
    return sum / kDirections;
}

// A lamp that comes in flat: what looks light up takes the interface's mean over even light, points take the lamp's
// own.
TEST(EnvironmentParts, PointsKnowWhatTheInterfaceLeavesOfLamps)
{
    const EnvironmentSampler lamp(test::panoramaOf(
        [](const dvec3& d) {
            return dvec3(0.1) +
                   dvec3(20.0) * std::exp(20.0 * (glm::dot(d, glm::normalize(dvec3(0.0, 0.3, -1.0))) - 1.0));
        },
        128));
    const double exact = bodyExactly(lamp);
    EXPECT_NEAR(bodyBy("vndf_lamps", lamp), exact, 1e-3 * exact);
    EXPECT_GT(bodyBy("split_sum", lamp), 1.05 * exact);
}

TEST(EnvironmentParts, OverEvenLightAndInTheDarkTheyAreOne)
{
    const EnvironmentSampler even(test::panoramaOf([](const dvec3&) { return dvec3(2.0); }, 32));
    EXPECT_NEAR(bodyBy("vndf_lamps", even), bodyBy("split_sum", even), 1e-4);
    const EnvironmentSampler below(test::panoramaOf([](const dvec3& d) { return dvec3(d.y < -0.5 ? 1.0 : 0.0); }, 32));
    EXPECT_EQ(bodyBy("vndf_lamps", below), 0.0);
}

} // namespace
} // namespace torrance
