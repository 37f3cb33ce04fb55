// The two writings of every shading formula against each other: GLSL on the device, double on the processor.
#include "brdf/dfg.h"
#include "study/probe_check.h"
#include "study/probe_grid.h"
#include "test_device.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace torrance {
namespace {

using namespace brdf;

class ScalarTerm : public testing::TestWithParam<const Method*>
{
};

void expectWithinAllowance(const ProbeCheck& check)
{
    const ProbeWorst worst = worstOf(test::device(), test::shaders(), check);
    EXPECT_LE(worst.ratio, 1.0) << "error " << worst.error << " at " << describe(check.rows[worst.row]);
}

TEST_P(ScalarTerm, DeviceAgreesWithDoubleFedTheSameScalars)
{
    expectWithinAllowance(methodCheck(*GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Brdf, ScalarTerm, testing::ValuesIn(probedMethods()), [](const auto& instance) {
    return std::string(slotPrefix(instance.param->slot)) + "_" + std::string(instance.param->id);
});

class WholeBrdf : public testing::TestWithParam<const Preset*>
{
};

TEST_P(WholeBrdf, DeviceAgreesWithDoubleWithinTheConditionOfTheFormula)
{
    expectWithinAllowance(brdfCheck(*GetParam()));
}

std::vector<const Preset*> presetPointers()
{
    std::vector<const Preset*> presets;
    for (const Preset& preset : allPresets())
        presets.push_back(&preset);
    return presets;
}

// GoogleTest's names hold no hyphens.
std::string identifier(std::string_view id)
{
    std::string name(id);
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Brdf, WholeBrdf, testing::ValuesIn(presetPointers()),
                         [](const auto& instance) { return identifier(instance.param->id); });

// Below r = 0.1 kappa of another distribution is not the whole of its rounding.
void expectRoughWithinAllowance(const Preset& preset)
{
    ProbeCheck check = brdfCheck(preset);
    std::erase_if(check.rows, [](const ShadingPoint& p) { return p.perceptualRoughness < 0.1; });
    expectWithinAllowance(check);
}

// Anisotropy 0 is isotropy, on whichever tangent; a Fresnel term of a reflectance needs the base colour only.
TEST(WholeBrdf, TakesTheAnisotropicDistributionAndAnyFresnelTermOfAReflectance)
{
    for (const Method& method : allMethods())
        if (method.id == "ggx_aniso" ||
            (method.slot == Slot::fresnel && method.needs == Interface::reflectance && method.id != "schlick"))
        {
            Preset preset = *findPreset("gltf");
            preset[method.slot] = &method;
            SCOPED_TRACE(method.id);
            expectRoughWithinAllowance(preset);
        }
}

// Channels of exp(-90) and less: a D that a device flushes to zero is made larger by V, and by 1 / n.l in a sketch.
bool isFaint(const dvec3& color)
{
    constexpr double kFaint = 1e-30;
    for (int c = 0; c < 3; ++c)
        if (color[c] > 0 && color[c] < kFaint)
            return true;
    return false;
}

// Each quirk turned on, each parameter moved from where it stands.
TEST(WholeBrdf, AgreesUnderEveryOptionOfAModel)
{
    for (const ModelOption& option : allModelOptions()) {
        SCOPED_TRACE(option.id);
        const std::vector<const Preset*> presets = presetPointers();
        Preset preset = **std::ranges::find_if(presets, [&](const Preset* p) { return p->model->id == option.model; });
        if (option.isQuirk())
            preset.options.*std::get<bool ModelOptions::*>(option.member) = true;
        else
            preset.options.*std::get<double ModelOptions::*>(option.member) = 0.375; // a float
        ProbeCheck check = brdfCheck(preset);
        std::erase_if(check.rows, [&](const ShadingPoint& p) { return isFaint(check.term.formula(p)); });
        expectWithinAllowance(check);
    }
}

// Any selection of D, V and diffuse makes a shader: the files can be included together, and the result is still within
// kappa.
TEST(WholeBrdf, TakesOtherMethodsInItsSlots)
{
    Preset preset = *findPreset("gltf");
    preset[Slot::distribution] = findMethod(Slot::distribution, "beckmann");
    preset[Slot::visibility] = findMethod(Slot::visibility, "vcavity");
    preset[Slot::diffuse] = findMethod(Slot::diffuse, "eon");
    expectRoughWithinAllowance(preset);
}

TEST(DirectionalAlbedo, TableIsWithinItsInterpolationOfTheIntegral)
{
    const ProbeCheck check = albedoCheck();
    expectWithinAllowance(check);

    const std::vector<ShadingPoint>& rows = check.rows;
    const std::vector<vec3> device =
        probe(test::device(), test::shaders(), makeProbeTerm(*findMethod(Slot::dfg, "table")), rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const dvec3 exact = DFG_table(rows[i].NoV, rows[i].perceptualRoughness);
        const double dielectric = exact.x * 0.04 + exact.y;
        EXPECT_NEAR((device[i].x * 0.04 + device[i].y) / dielectric, 1.0, 1e-4) << describe(rows[i]);
        EXPECT_NEAR((1 - device[i].z) / (1 - exact.z), 1.0, 1e-4) << describe(rows[i]); // the diffuse part is (1 - w)
    }
}

TEST_P(ScalarTerm, IsFiniteAndZeroBelowTheHorizonAtEveryCorner)
{
    EXPECT_EQ(cornerFault(test::device(), test::shaders(), *GetParam()), "");
}

vec3 onDevice(const ProbeTerm& term, const ShadingPoint& point)
{
    return probe(test::device(), test::shaders(), term, std::vector{point}).front();
}

TEST(WholeBrdfCorner, ReflectsNothingBelowTheHorizonAndWithoutAHalfVector)
{
    const ProbeTerm gltf = makeBrdfTerm(*findPreset("gltf"));
    for (const double r : {0.0, 0.01, 0.5, 1.0}) {
        EXPECT_EQ(onDevice(gltf, makeShadingPoint({0, 0, 1}, {0.2, 0.3, -0.1}, {0, 0.1, 0.9}, r)), vec3(0));
        EXPECT_EQ(onDevice(gltf, makeShadingPoint({0, 0, 1}, {0, 0.1, 0.9}, {0.2, 0.3, -0.1}, r)), vec3(0));
        EXPECT_EQ(onDevice(gltf, makeShadingPoint({0, 0, 1}, {0, 1, 0}, {0, -1, 0}, r)), vec3(0));
    }
}

TEST(WholeBrdfCorner, IsAFiniteHighlightAtRoughnessZero)
{
    ShadingPoint mirror = makeShadingPoint({0, 0, 1}, {0, 0.28, 0.96}, {0, -0.28, 0.96}, 0.0);
    mirror.metallic = 1;
    // V = 1/(4 NoV NoL) for a mirror, D = 1/(pi kMinAlpha^2), F = 1
    const double expected = 1.0 / (4 * 0.96 * 0.96) / (kPi * kMinAlpha * kMinAlpha);
    EXPECT_NEAR(onDevice(makeBrdfTerm(*findPreset("gltf")), mirror).x / expected, 1.0, 1e-6);
}

TEST(FresnelCorner, IndexOneReflectsExactlyNothingAndIndexZeroAll)
{
    const ProbeTerm dielectric = makeProbeTerm(*findMethod(Slot::fresnel, "exact_dielectric"));
    const ProbeTerm conductor = makeProbeTerm(*findMethod(Slot::fresnel, "exact_conductor"));
    const ProbeTerm lazanyi = makeProbeTerm(*findMethod(Slot::fresnel, "lazanyi"));
    ShadingPoint p;
    for (const double VoH : {0.0, 1e-20, 0.01, 0.5, 1.0}) {
        p.VoH = VoH;
        p.ior = 1;
        p.eta = dvec3(1);
        p.k = dvec3(0);
        EXPECT_EQ(onDevice(dielectric, p), vec3(0)) << VoH;
        EXPECT_EQ(onDevice(conductor, p), vec3(0)) << VoH;
        EXPECT_EQ(onDevice(lazanyi, p), vec3(0)) << VoH;
        p.ior = 0;
        EXPECT_EQ(onDevice(dielectric, p), vec3(1)) << VoH;
    }
    p.VoH = 0.3; // cos of the critical angle for 0.75 is 0.66
    p.ior = 0.75;
    EXPECT_EQ(onDevice(dielectric, p), vec3(1)) << "beyond the critical angle";
}

} // namespace
} // namespace torrance
