// f(v, l) = f(l, v): every row that claims it keeps it, and no row that keeps it forgets to say so.
#include "brdf/brdf.h"
#include "points.h"

#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

// A method by itself changes sides with the others that gltf has.
Preset presetWith(const Method& method)
{
    Preset preset = *findPreset("gltf");
    preset[method.slot] = &method;
    return preset;
}

double apart(const Preset& preset)
{
    double worst = 0;
    for (const double NoV : {0.02, 0.4, 0.9})
        for (const double NoL : {0.05, 0.5, 1.0})
            for (const double roughness : {0.3, 0.9})
                for (const double azimuth : {0.3, 2.4}) {
                    ShadingPoint point = pointAt(NoV, NoL, azimuth, roughness);
                    ShadingPoint swapped = makeShadingPoint(point.n, point.l, point.v, roughness);
                    point.metallic = swapped.metallic = 0.3;
                    point.baseColor = swapped.baseColor = dvec3(0.8, 0.5, 0.2);
                    const dvec3 there = evaluateBrdf(preset, point), back = evaluateBrdf(preset, swapped);
                    for (int c = 0; c < 3; ++c)
                        worst = std::max(worst, std::abs(there[c] / back[c] - 1.0));
                }
    return worst;
}

TEST(Reciprocity, HoldsExactlyWhereTheRegistrySaysSo)
{
    constexpr double kRounding = 1e-11;
    for (const Method& method : allMethods()) {
        if (!std::holds_alternative<ScalarFormula>(method.formula) &&
            !std::holds_alternative<ColorFormula>(method.formula))
            continue;
        if (method.slot == Slot::sheen)
            continue; // of no model yet; the sweep of tests/gpu/stability.cpp swaps v and l in it
        if (method.slot == Slot::fresnel && method.needs != Interface::reflectance)
            continue; // a glTF material gives it nothing to read; it is a function of VoH alone
        EXPECT_EQ(apart(presetWith(method)) < kRounding, method.reciprocal)
            << slotName(method.slot) << ' ' << method.id;
    }
}

TEST(Reciprocity, OfModelsIsWhatTheirRowsSay)
{
    for (const Preset& preset : allPresets())
        if (!isComposed(preset)) {
            EXPECT_EQ(apart(preset) < 1e-11, preset.model->reciprocal) << preset.id;
        }
}

} // namespace
} // namespace torrance::brdf
