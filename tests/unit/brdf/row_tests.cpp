// That every row of the registry has a test. A new row of a slot whose tests iterate over the registry has one without
// being named; a row that is judged by image needs a line here.
#include "brdf/method.h"
#include "brdf/selection.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace torrance::brdf {
namespace {

struct RowTest
{
    Slot slot;
    std::string_view id; // empty: every row of the slot, by a file that iterates over the registry
    std::string_view file, suite, test;
};

constexpr std::string_view kTerms = "tests/gpu/brdf_terms.cpp", kScalars = "DeviceAgreesWithDoubleFedTheSameScalars";

constexpr RowTest kRowTests[] = {
    {Slot::model, "", kTerms, "WholeBrdf", "DeviceAgreesWithDoubleWithinTheConditionOfTheFormula"},
    {Slot::distribution, "", kTerms, "ScalarTerm", kScalars},
    {Slot::visibility, "", kTerms, "ScalarTerm", kScalars},
    {Slot::fresnel, "", kTerms, "ScalarTerm", kScalars},
    {Slot::diffuse, "", kTerms, "ScalarTerm", kScalars},
    {Slot::sheen, "", kTerms, "ScalarTerm", kScalars},
    {Slot::diffuseWeight, "", kTerms, "ScalarTerm", kScalars},
    {Slot::multipleScattering, "", kTerms, "ScalarTerm", kScalars},
    {Slot::environmentDiffuse, "", "tests/image/environment_methods.cpp", "EnvironmentDiffuse",
     "EveryMethodIsItsFormula"},
    {Slot::environmentSpecular, "", "tests/image/environment_methods.cpp", "EnvironmentSpecular",
     "EveryMethodIsItsFormulaUnderARealEnvironment"},
    {Slot::environmentSpecular, "phong_levels", "tests/image/source_environment.cpp", "SourceEnvironment",
     "EveryPixelIsTheFormulaUnderARealEnvironment"},
    {Slot::environmentSpecular, "ggx_levels", "tests/image/source_environment.cpp", "SourceEnvironment",
     "GgxBurleyIsItsFormulaUnderARealEnvironment"},
    {Slot::environmentSpecular, "mirror", "tests/image/source_environment.cpp", "SourceEnvironment",
     "PhongIsItsFormulaUnderARealEnvironment"},
    {Slot::dfg, "", "tests/unit/brdf/dfg.cpp", "Dfg", "EveryTableIsARow"},
    {Slot::areaLight, "point", "tests/unit/brdf/area_light.cpp", "AreaLight",
     "PointFollowsTheInverseSquareAndTheCosine"},
    {Slot::areaLight, "representative", "tests/image/area_lights.cpp", "AreaLights", "EveryMethodIsItsFormula"},
    {Slot::areaLight, "sampled", "tests/image/area_lights.cpp", "AreaLights", "EveryMethodIsItsFormula"},
    {Slot::textureFilter, "trilinear", "tests/image/texture_filters.cpp", "TextureFilters", "EveryFilterIsItsFormula"},
    {Slot::textureFilter, "trilinear_exact", "tests/image/texture_filters.cpp", "TextureFilters",
     "EveryFilterIsItsFormula"},
    {Slot::textureFilter, "nearest_level", "tests/image/texture_filters.cpp", "TextureFilters",
     "EveryFilterIsItsFormula"},
    {Slot::textureFilter, "trilinear_words", "tests/image/texture_filters.cpp", "TextureFilters",
     "WordsAreTheirTextures"},
    {Slot::specularAntialiasing, "toksvig", "tests/image/specular_antialiasing.cpp", "SpecularAntialiasing",
     "ToksvigCalmsAMinifiedNormalMap"},
    {Slot::specularAntialiasing, "tokuyoshi", "tests/image/specular_antialiasing.cpp", "SpecularAntialiasing",
     "TokuyoshiCalmsASmallSphere"},
    {Slot::specularAntialiasing, "none", "tests/image/furnace.cpp", "Furnace", "MetalReturnsWhatTheModelSays"},
    {Slot::pixelSampling, "supersampled", "tests/unit/brdf/pixel_sampling.cpp", "PixelSampling",
     "SupersampledIsTheMean"},
    {Slot::pixelSampling, "reconstructed", "tests/image/pixel_sampling.cpp", "PixelSampling",
     "DeviceAgreesWithTheFormula"},
    {Slot::tone, "", "tests/unit/brdf/tone_rows.cpp", "ToneRows", "AreTheCurvesThatPicturesAreWrittenWith"},
    {Slot::transfer, "", "tests/unit/brdf/tone_rows.cpp", "ToneRows",
     "TransferRowsAreTheCurvesThatPicturesAreWrittenWith"},
};

std::string textOf(std::string_view file)
{
    std::ostringstream text;
    text << std::ifstream(std::filesystem::path(TORRANCE_SOURCE_DIR) / file).rdbuf();
    return text.str();
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

bool exists(const RowTest& test)
{
    const std::string name = "(" + std::string(test.suite) + ", " + std::string(test.test) + ")";
    const std::string text = textOf(test.file);
    return contains(text, "TEST" + name) || contains(text, "TEST_P" + name);
}

bool iterates(const std::string& text)
{
    return contains(text, "allMethods()") || contains(text, "probedMethods()");
}

// By its id, by its formula, or by a preset that it stands in.
bool names(const std::string& text, const Method& method)
{
    const auto quoted = [](std::string_view word) { return "\"" + std::string(word) + "\""; };
    return contains(text, quoted(method.id)) || contains(text, functionName(method)) ||
           std::ranges::any_of(allPresets(), [&](const Preset& preset) {
               return preset[method.slot] == &method && contains(text, quoted(preset.id));
           });
}

bool covers(const RowTest& test, const Method& method)
{
    if (test.slot != method.slot)
        return false;
    return test.id.empty() ? iterates(textOf(test.file)) : test.id == method.id && names(textOf(test.file), method);
}

TEST(Registry, EveryRowHasATest)
{
    for (const Method& method : allMethods()) {
        EXPECT_TRUE(std::ranges::any_of(kRowTests, [&](const RowTest& test) { return covers(test, method); }))
            << functionName(method) << " has no test: give it one, and a line in tests/unit/brdf/row_tests.cpp";
    }
}

TEST(Registry, EveryTestOfARowExistsAndItsRowToo)
{
    for (const RowTest& test : kRowTests) {
        EXPECT_TRUE(exists(test)) << test.file << " has no test " << test.suite << "." << test.test;
        if (!test.id.empty()) {
            EXPECT_NE(findMethod(test.slot, test.id), nullptr) << slotName(test.slot) << ' ' << test.id;
        }
    }
}

} // namespace
} // namespace torrance::brdf
