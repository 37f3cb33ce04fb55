#include "brdf/diffuse_weight.h"

#include "brdf/albedo.h"
#include "brdf/brdf.h"
#include "brdf/lobe_albedo.h"
#include "brdf/lobe_albedo_table.h"
#include "math/quadrature.h"
#include "points.h"

#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

Preset withWeight(std::string_view id)
{
    Preset preset = *findPreset("gltf");
    preset.diffuseWeight = findMethod(Slot::diffuseWeight, id);
    return preset;
}

double schlick(double cosine)
{
    return kDielectricF0 + (1.0 - kDielectricF0) * std::pow(1.0 - cosine, 5);
}

// The second form: each weight from its definition, beside Lambert's 1/pi.
TEST(DiffuseWeight, IsItsDefinitionOverALambertianBody)
{
    for (ShadingPoint point : gridOfPoints()) {
        if (point.perceptualRoughness != 0.5)
            continue;
        point.baseColor = dvec3(0.5);
        const auto weightOf = [&](std::string_view id) {
            return evaluateTerms(withWeight(id), point).diffuse.g * 2.0 * kPi;
        };
        const AlbedoTerms terms = ggxAlbedo(std::min(point.NoV, 1.0), 0.5);
        EXPECT_NEAR(weightOf("fresnel_voh"), 1.0 - schlick(point.VoH), 1e-14);
        EXPECT_NEAR(weightOf("fresnel_nol_nov"), (1.0 - schlick(point.NoL)) * (1.0 - schlick(point.NoV)), 1e-13);
        EXPECT_NEAR(weightOf("albedo_scaling"), 1.0 - kDielectricF0 * terms.scale - terms.bias, 1e-14);
    }
}

// Under uniform light a white body weighted by albedo returns what the interface does not: all light, whatever the
// lobe. That is so for any albedos, if both are told the same: the model reads the table where it needs that of the
// light (lobe_albedo_table.h).
TEST(DiffuseWeight, AlbedoScalingMakesAWhiteDielectricReturnAllLight)
{
    for (const char* compensation : {"none", "scale", "kulla_conty", "fdez_aguera"}) {
        Preset preset = withWeight("albedo_scaling");
        preset.multipleScattering = findMethod(Slot::multipleScattering, compensation);
        ShadingPoint point = pointAt(0.3, 0.6, 1.0, 0.7);
        const double body = evaluateTerms(preset, point).diffuse.g * kPi; // the same at every l
        setLobeAlbedo(point);
        if (preset.multipleScattering->readsLightAlbedo) {
            point.E = lobeAlbedoFromTable(point.NoV, point.perceptualRoughness);
            point.EAverage = averageLobeAlbedoFromTable(point.perceptualRoughness);
        }
        point.f0 = dvec3(kDielectricF0);
        point.single = point.f0 * (point.E - point.bias) + point.bias;
        point.spread = dvec3(1);
        point.ELight = point.EAverage;
        EXPECT_NEAR(body + valueOf(*preset.multipleScattering, point).g, 1.0, 1e-14) << compensation;
    }
}

// What the environment's light rests on: given Fresnel's means over uniform light, a weight is the body's mean weight.
TEST(DiffuseWeight, MeansOfItsArgumentsGiveTheMeanWeight)
{
    const QuadratureRule cosines = gaussLegendre(48, 0.0, 1.0), azimuths = gaussLegendre(48, 0.0, kPi);
    for (const Method& method : allMethods()) {
        if (method.slot != Slot::diffuseWeight)
            continue;
        const Preset preset = withWeight(method.id);
        for (const double NoV : {0.2, 0.7}) {
            const double sum = integrate(cosines, [&](double root) {
                const double NoL = root * root;
                return 2.0 * root * NoL * 2.0 * integrate(azimuths, [&](double phi) {
                           return evaluateTerms(preset, pointAt(NoV, NoL, phi, 0.5)).diffuse.g;
                       });
            });
            ShadingPoint point = pointAt(NoV, 0.5, 0.0, 0.5);
            setInterface(point);
            const auto mean = [](double w) { return dvec3(kDielectricF0 + (1.0 - kDielectricF0) * w); };
            point.F = mean(schlickDiffuseWeight(NoV));
            point.FNoL = mean(1.0 / 21.0);
            EXPECT_NEAR(sum, valueOf(method, point).g, 1e-6) << method.id << ' ' << NoV;
        }
    }
}

TEST(DiffuseWeight, LiesWithinZeroAndOne)
{
    for (const Method& method : allMethods())
        if (method.slot == Slot::diffuseWeight)
            for (ShadingPoint point : gridOfPoints()) {
                if (point.perceptualRoughness != 0.3)
                    continue;
                setInterface(point);
                const double weight = valueOf(method, point).r;
                EXPECT_TRUE(weight >= 0 && weight <= 1) << method.id << ' ' << weight;
            }
}

} // namespace
} // namespace torrance::brdf
