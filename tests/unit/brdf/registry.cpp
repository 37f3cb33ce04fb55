#include "brdf/brdf.h"
#include "brdf/method.h"
#include "brdf/selection.h"
#include "core/error.h"
#include "image/tone_curves.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <set>
#include <sstream>

namespace torrance::brdf {
namespace {

const std::filesystem::path kShaders = std::filesystem::path(TORRANCE_SOURCE_DIR) / "shaders";

std::string readText(const std::filesystem::path& path)
{
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

// Names of the functions that the text defines: a type at the start of a line, a name, a parenthesis.
std::vector<std::string> functionsOf(const std::string& text)
{
    static const std::regex definition(R"((?:^|\n)(?:float|vec[234]|void|int|bool|mat[34]|BrdfTerms) (\w+)\()");
    std::vector<std::string> names;
    for (std::sregex_iterator it(text.begin(), text.end(), definition), end; it != end; ++it)
        names.push_back((*it)[1]);
    return names;
}

TEST(Registry, EveryRowHasWhatADocumentationTableNeeds)
{
    for (const Method& method : allMethods()) {
        EXPECT_FALSE(method.id.empty());
        EXPECT_GE(method.citation.size(), 10u) << functionName(method) << " needs a citation";
        EXPECT_FALSE(method.domain.text.empty()) << functionName(method) << " needs a domain";
    }
}

TEST(Registry, NamesAreUniqueAndFound)
{
    std::set<std::string> names;
    for (const Method& method : allMethods()) {
        EXPECT_TRUE(names.insert(functionName(method)).second) << functionName(method) << " stands twice";
        EXPECT_EQ(findMethod(method.slot, method.id), &method);
    }
    for (const Slot slot : allSlots())
        EXPECT_EQ(findSlot(slotName(slot)), slot);
    EXPECT_EQ(findMethod(Slot::distribution, "smith_corr"), nullptr);
    EXPECT_EQ(findSlot("shininess"), std::nullopt);
}

TEST(Registry, EveryShadingMethodIsOneFunctionInAFileOfItsName)
{
    for (const Method& method : allMethods()) {
        if (!hasShadingFunction(method.slot))
            continue;
        const auto path = kShaders / glslPath(method);
        ASSERT_TRUE(std::filesystem::exists(path)) << path;
        EXPECT_EQ(functionsOf(readText(path)), std::vector{functionName(method)}) << path;
        EXPECT_FALSE(std::holds_alternative<NoFormula>(method.formula)) << path << " has no double formula";
    }
}

TEST(Registry, EveryFileOfASlotHasARow)
{
    for (const Slot slot : allSlots()) {
        const auto folder = kShaders / "brdf" / slotName(slot);
        EXPECT_EQ(std::filesystem::is_directory(folder), hasShadingFunction(slot)) << folder;
        if (!hasShadingFunction(slot))
            continue;
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            EXPECT_EQ(entry.path().extension(), ".glsl") << entry.path();
            EXPECT_NE(findMethod(slot, entry.path().stem().string()), nullptr) << entry.path() << " has no row";
        }
    }
}

TEST(Registry, EveryFileThatARowNamesExists)
{
    for (const Method& method : allMethods()) {
        if (!method.file.empty()) {
            EXPECT_TRUE(std::filesystem::is_regular_file(kShaders / glslPath(method))) << functionName(method);
        }
    }
}

TEST(Registry, EveryToneCurveHasARowWithItsFormula)
{
    for (const ToneCurve& curve : allToneCurves()) {
        const Method* method = findMethod(Slot::tone, curve.id);
        ASSERT_NE(method, nullptr) << curve.id;
        EXPECT_EQ(std::get<CurveFormula>(method->formula), curve.exact) << curve.id;
    }
}

TEST(Registry, PiIsTypedOnceInAllShaders)
{
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kShaders))
        if (entry.is_regular_file() && entry.path().filename() != "constants.h") {
            EXPECT_EQ(readText(entry.path()).find("3.14159"), std::string::npos) << entry.path();
        }
}

TEST(Preset, HasAMethodOfTheRightSlotEverywhere)
{
    ASSERT_EQ(allPresets().front().id, "standard") << "the default comes first";
    for (const Preset& preset : allPresets())
        for (const Slot slot : allSlots()) {
            if (slot == Slot::sheen || slot == Slot::tone || slot == Slot::transfer ||
                (!isComposed(preset) && !preset[slot]))
                continue;
            ASSERT_NE(preset[slot], nullptr) << preset.id << ' ' << slotName(slot);
            EXPECT_EQ(preset[slot]->slot, slot);
        }
    Preset changed = *findPreset("gltf");
    changed[Slot::distribution] = findMethod(Slot::distribution, "beckmann");
    EXPECT_EQ(changed.distribution->id, "beckmann");
    EXPECT_THROW(changed[Slot::tone] = nullptr, std::out_of_range);
    EXPECT_EQ(findPreset("gltf2"), nullptr);
}

TEST(Selection, IncludesAndDefinesOneFunctionPerSlot)
{
    EXPECT_EQ(selectedGlsl(*findPreset("standard")), R"(#include "brdf/distribution/ggx.glsl"
#define SELECTED_distribution D_ggx
#include "brdf/visibility/smith_corr.glsl"
#define SELECTED_visibility V_smith_corr
#include "brdf/fresnel/schlick.glsl"
#define SELECTED_fresnel F_schlick
#include "brdf/diffuse/lambert.glsl"
#define SELECTED_diffuse Fd_lambert
#include "brdf/diffuse_weight/fresnel_voh.glsl"
#define SELECTED_diffuse_weight W_fresnel_voh
#include "brdf/multiple_scattering/scale.glsl"
#define SELECTED_multiple_scattering M_scale
#include "brdf/model/gltf.glsl"
#define SELECTED_model model_gltf
)");
}

// A source's D, G, F and diffuse are part of its model: another in their place would be another system.
TEST(Preset, OfASourceHasNoMethodsBesideItsModel)
{
    for (const Preset& preset : allPresets())
        for (const Slot slot : {Slot::distribution, Slot::visibility, Slot::fresnel, Slot::diffuse, Slot::diffuseWeight,
                                Slot::multipleScattering})
            EXPECT_EQ(preset[slot] != nullptr, isComposed(preset)) << preset.id << ' ' << slotName(slot);
    EXPECT_EQ(selectedGlsl(*findPreset("ue4-direct")), R"(const bool QUIRK_double_fresnel = false;
#include "brdf/model/ue4_direct.glsl"
#define SELECTED_model model_ue4_direct
)");
}

TEST(Preset, ExistsForEveryModel)
{
    for (const Method& method : allMethods())
        if (method.slot == Slot::model) {
            EXPECT_TRUE(std::ranges::any_of(allPresets(), [&](const Preset& p) { return p.model == &method; }))
                << method.id;
        }
}

TEST(Selection, RefusesAFresnelTermThatNeedsAnIndex)
{
    Preset preset = *findPreset("gltf");
    preset.fresnel = findMethod(Slot::fresnel, "exact_conductor");
    EXPECT_THROW(selectedGlsl(preset), Error);
    EXPECT_THROW(evaluateBrdf(preset, ShadingPoint()), Error);
}

} // namespace
} // namespace torrance::brdf
