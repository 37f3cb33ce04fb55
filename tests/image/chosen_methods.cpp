// Any method of a slot in the place of gltf's own draws what its formula says: spheres under a point light, pixel by
// pixel.
#include "study/shape_cases.h"

#include "brdf/selection.h"
#include "drawing.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

using brdf::Method;
using brdf::Slot;

/// Of the slots that make up a BRDF; not the Fresnel terms of an index, which a base colour does not give.
std::vector<const Method*> chosenMethods()
{
    std::vector<const Method*> methods;
    const brdf::Preset& gltf = *brdf::findPreset("gltf");
    for (const Method& method : brdf::allMethods())
        if (brdf::hasShadingFunction(method.slot) && method.slot != Slot::model && gltf[method.slot] &&
            gltf[method.slot] != &method && method.needs == brdf::Interface::reflectance)
            methods.push_back(&method);
    return methods;
}

class ChosenMethod : public testing::TestWithParam<const Method*>
{
};

TEST_P(ChosenMethod, DrawsWhatItsFormulaSays)
{
    brdf::Preset preset = *brdf::findPreset("gltf");
    preset[GetParam()->slot] = GetParam();
    const std::vector<PictureCase> spheres = presetSpheres(preset);
    constexpr std::size_t kRoughMetal = 1, kDielectric = 2; // roughness 0.6, 0.25
    expectDrawnAsComputed({spheres[kRoughMetal]});
    if (GetParam()->domain.leastRoughness == 0.0) // below or near such an end a method errs by what its row says
        expectDrawnAsComputed({spheres[kDielectric]});
}

INSTANTIATE_TEST_SUITE_P(Slots, ChosenMethod, testing::ValuesIn(chosenMethods()),
                         [](const auto& instance) { return brdf::functionName(*instance.param); });

} // namespace
} // namespace torrance::test
