// A sphere under each source system: every pixel is what the source's own formulas give in double
// (src/study/shape_cases.cpp).
#include "study/shape_cases.h"

#include "drawing.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

std::vector<const brdf::Preset*> sourcePresets()
{
    std::vector<const brdf::Preset*> presets;
    for (const brdf::Preset& preset : brdf::allPresets())
        if (!brdf::isComposed(preset))
            presets.push_back(&preset);
    return presets;
}

class SourceSphere : public testing::TestWithParam<const brdf::Preset*>
{
};

TEST_P(SourceSphere, EveryPixelIsTheSourcesOwnFormula)
{
    expectDrawnAsComputed(presetSpheres(*GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Source, SourceSphere, testing::ValuesIn(sourcePresets()), [](const auto& instance) {
    std::string name(instance.param->id);
    std::ranges::replace(name, '-', '_');
    return name;
});

} // namespace
} // namespace torrance::test
