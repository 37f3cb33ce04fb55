// The two writings of every shading formula against each other: GLSL on the device, double on the processor.
#include "brdf/condition.h"
#include "brdf/dfg.h"
#include "passes/probe_pass.h"
#include "test_device.h"

#include <cfloat>
#include <gtest/gtest.h>
#include <iomanip>
#include <random>
#include <sstream>

namespace torrance {
namespace {

using namespace brdf;

// What is left of a double after the device has been given it. volatile: g++ 12 drops the rounding of two neighbouring
// doubles to float and back when it vectorises straight-line code (-ftree-slp-vectorize, part of -O2).
double asFloat(double x)
{
    const volatile float rounded = static_cast<float>(x);
    return rounded;
}

dvec3 asFloat(const dvec3& x)
{
    return {asFloat(x.x), asFloat(x.y), asFloat(x.z)};
}

// The point whose scalars are those that the device sees: both sides then compute from the same numbers.
ShadingPoint scalarsRounded(ShadingPoint p)
{
    for (double* scalar : {&p.NoV, &p.NoL, &p.VoL, &p.NoH, &p.VoH, &p.oneLessVoH, &p.sin2H, &p.perceptualRoughness,
                           &p.alpha, &p.ior, &p.metallic, &p.E})
        *scalar = asFloat(*scalar);
    for (dvec3* color : {&p.f0, &p.f90, &p.eta, &p.k, &p.baseColor})
        *color = asFloat(*color);
    return p;
}

dvec3 directionAt(double cosine, double azimuth)
{
    const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

class Random
{
public:
    double uniform(double from, double to) { return from + (to - from) * (static_cast<double>(engine()) / 0x1p64); }
    dvec3 direction() { return directionAt(uniform(-1, 1), uniform(0, 2 * kPi)); }
    dvec3 color() { return {uniform(0, 1), uniform(0, 1), uniform(0, 1)}; }

private:
    std::mt19937_64 engine{20240607};
};

void giveMaterial(ShadingPoint& point, Random& random)
{
    point.baseColor = random.color();
    if (random.uniform(0, 1) < 0.3)
        point.baseColor = glm::round(point.baseColor); // black and saturated metals
    point.metallic = std::clamp(random.uniform(-0.3, 1.3), 0.0, 1.0);
    point.f0 = random.color();
    point.ior = random.uniform(0.4, 3.0);
    point.eta = random.color() * 4.0 + 0.05;
    point.k = random.color() * 8.0;
    point.E = random.uniform(0.3, 1.0);
}

// Turns the +Z axis into n.
dvec3 turned(const dvec3& n, const dvec3& d)
{
    const dvec3 t = glm::normalize(glm::cross(std::abs(n.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0), n));
    return t * d.x + glm::cross(n, t) * d.y + n * d.z;
}

// Roughness 0.01 to 1, cosines from grazing to normal, azimuths to the mirror direction, normals along an axis and
// tilted; and random rows, a half of them with h within a few widths of the highlight.
std::vector<ShadingPoint> denseRows()
{
    std::vector<ShadingPoint> rows;
    Random random;
    const dvec3 tilted = glm::normalize(dvec3(0.3, -0.7, 0.5));
    for (const dvec3& n : {dvec3(0, 0, 1), tilted})
        for (const double r : {0.01, 0.014, 0.02, 0.03, 0.05, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0})
            for (const double NoV : {0.005, 0.05, 0.2, 0.5, 0.8, 0.97, 1.0})
                for (const double NoL : {0.005, 0.05, 0.2, 0.5, 0.8, 0.97, 1.0})
                    for (const double azimuth : {0.0, 0.4, 1.3, 2.2, 3.0, kPi}) {
                        rows.push_back(makeShadingPoint(n, turned(n, directionAt(NoV, 0.2)),
                                                        turned(n, directionAt(NoL, 0.2 + azimuth)), r));
                        giveMaterial(rows.back(), random);
                    }
    for (int i = 0; i < 20000; ++i) {
        const double r = random.uniform(0.01, 1.0);
        const dvec3 n = random.direction();
        const dvec3 v = turned(n, directionAt(random.uniform(0.001, 1.0), random.uniform(0, 2 * kPi)));
        dvec3 l = turned(n, directionAt(random.uniform(0.001, 1.0), random.uniform(0, 2 * kPi)));
        if (i % 2 == 0) {
            const double tangent = r * r * random.uniform(0.0, 4.0);
            const dvec3 h = turned(n, directionAt(1 / std::sqrt(1 + tangent * tangent), random.uniform(0, 2 * kPi)));
            l = 2 * glm::dot(v, h) * h - v;
        }
        rows.push_back(makeShadingPoint(n, v, l, r));
        giveMaterial(rows.back(), random);
    }
    return rows;
}

// Of the worst channel. A device may flush to zero what lies below the least normal float, be it the value or a term of
// it: that much is forgiven.
double relativeError(const vec3& device, const dvec3& exact)
{
    double worst = 0;
    for (int channel = 0; channel < 3; ++channel) {
        const double d = device[channel], c = exact[channel];
        if (!std::isfinite(d) || !std::isfinite(c))
            return INFINITY;
        if (std::abs(d - c) > FLT_MIN)
            worst = std::max(worst, (std::abs(d - c) - FLT_MIN) / std::max(std::abs(c), static_cast<double>(FLT_MIN)));
    }
    return worst;
}

std::string described(const ShadingPoint& p)
{
    std::ostringstream text;
    text << std::setprecision(9) << "NoV=" << p.NoV << " NoL=" << p.NoL << " NoH=" << p.NoH << " VoH=" << p.VoH
         << " VoL=" << p.VoL << " sin2H=" << p.sin2H << " r=" << p.perceptualRoughness << " ior=" << p.ior
         << " eta=" << p.eta.x << " k=" << p.k.x << " metallic=" << p.metallic;
    return text.str();
}

struct Worst
{
    double ratio = -1; // error over what is allowed
    double error = 0;
    std::size_t row = 0;
};

template <typename Allowed>
Worst worstOf(const ProbeTerm& term, const std::vector<ShadingPoint>& rows, const Allowed& allowed)
{
    const std::vector<vec3> device = probe(test::device(), test::shaders(), term, rows);
    Worst worst;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double error = relativeError(device[i], term.formula(rows[i]));
        const double ratio = error / allowed(rows[i]);
        if (!(ratio <= worst.ratio))
            worst = {ratio, error, i};
    }
    return worst;
}

class ScalarTerm : public testing::TestWithParam<const Method*>
{
};

constexpr double kRounding = 0x1p-24;

// 5e-6: forty roundings of 2^-23; every formula has fewer operations on its path than that. The textbook's D is the
// exception that it is kept for: three roundings of its cancelling sum d, 6 * 2^-24 in D for d near 1, grow as 1/d (and
// beyond first order where d is mostly rounding: there it is only asked to be finite).
double allowedFor(const Method& method, const ShadingPoint& p)
{
    if (method.id != "ggx_textbook")
        return 5e-6;
    const double growth = 1.0 / (p.NoH * p.NoH * (p.alpha * p.alpha - 1.0) + 1.0);
    return growth * kRounding > 0.01 ? DBL_MAX : 5e-6 + 6 * kRounding * growth;
}

TEST_P(ScalarTerm, DeviceAgreesWithDoubleFedTheSameScalars)
{
    const Method& method = *GetParam();
    std::vector<ShadingPoint> rows = denseRows();
    for (ShadingPoint& row : rows)
        row = scalarsRounded(row);
    const Worst worst =
        worstOf(makeProbeTerm(method), rows, [&](const ShadingPoint& p) { return allowedFor(method, p); });
    EXPECT_LE(worst.ratio, 1.0) << "error " << worst.error << " at " << described(rows[worst.row]);
}

std::vector<const Method*> methodsWithShadingFunction()
{
    std::vector<const Method*> methods;
    for (const Method& method : allMethods())
        if (hasShadingFunction(method.slot))
            methods.push_back(&method);
    return methods;
}

INSTANTIATE_TEST_SUITE_P(Brdf, ScalarTerm, testing::ValuesIn(methodsWithShadingFunction()), [](const auto& instance) {
    return std::string(slotPrefix(instance.param->slot)) + "_" + std::string(instance.param->id);
});

class WholeBrdf : public testing::TestWithParam<const Preset*>
{
};

// The vectors are rounded to float on their way to the device, the double formula sees them whole: kappa 2^-24 is what
// that alone can make of them, and as much again is for the arithmetic. Below r = 0.02 the highlight is narrower than
// the device's arithmetic on v + l resolves well.
double allowedForVectors(const ProbeTerm& term, const ShadingPoint& p)
{
    const double factor = p.perceptualRoughness < 0.02 ? 8 : 2;
    return 2e-6 + factor * conditionNumber(term.formula, p) * kRounding;
}

std::vector<ShadingPoint> rowsFor(const ProbeTerm& term)
{
    std::vector<ShadingPoint> rows = denseRows();
    constexpr std::size_t kPart = 53; // an exact albedo takes a millisecond's fraction, and kappa asks for twenty
    if (term.readsAlbedo) {
        std::vector<ShadingPoint> part;
        for (std::size_t i = 0; i < rows.size(); i += kPart) {
            part.push_back(rows[i]);
            part.back().E = lobeAlbedo(rows[i].NoV, rows[i].perceptualRoughness);
        }
        rows = part;
    }
    for (ShadingPoint& row : rows) // kappa speaks of directions and roughness only
    {
        row.baseColor = asFloat(row.baseColor);
        row.metallic = asFloat(row.metallic);
    }
    return rows;
}

TEST_P(WholeBrdf, DeviceAgreesWithDoubleWithinTheConditionOfTheFormula)
{
    const ProbeTerm term = makeBrdfTerm(*GetParam());
    const std::vector<ShadingPoint> rows = rowsFor(term);
    const Worst worst = worstOf(term, rows, [&](const ShadingPoint& p) { return allowedForVectors(term, p); });
    EXPECT_LE(worst.ratio, 1.0) << "error " << worst.error << " at " << described(rows[worst.row]);
}

INSTANTIATE_TEST_SUITE_P(Brdf, WholeBrdf, testing::Values(findPreset("gltf"), findPreset("standard")),
                         [](const auto& instance) { return std::string(instance.param->id); });

// Any selection of D, V and diffuse makes a shader: the files can be included together, and the result is still within
// kappa.
TEST(WholeBrdf, TakesOtherMethodsInItsSlots)
{
    Preset preset = *findPreset("gltf");
    preset[Slot::distribution] = findMethod(Slot::distribution, "beckmann");
    preset[Slot::visibility] = findMethod(Slot::visibility, "vcavity");
    preset[Slot::diffuse] = findMethod(Slot::diffuse, "eon");
    const ProbeTerm term = makeBrdfTerm(preset);
    std::vector<ShadingPoint> rows = rowsFor(term);
    std::erase_if(rows, [](const ShadingPoint& p) { return p.perceptualRoughness < 0.1; });
    const Worst worst = worstOf(term, rows, [&](const ShadingPoint& p) { return allowedForVectors(term, p); });
    EXPECT_LE(worst.ratio, 1.0) << "error " << worst.error << " at " << described(rows[worst.row]);
}

// The table is linear between its nodes: within 1e-4 of scale F0 + bias for F0 in [0.04, 1] (src/prepare/dfg_table.h),
// so of E.
TEST(DirectionalAlbedo, TableIsWithinItsInterpolationOfTheIntegral)
{
    std::vector<ShadingPoint> rows;
    for (int i = 0; i < 400; ++i) {
        const double NoV = 0.05 + 0.95 * (i % 20) / 19.0, r = 0.05 + 0.95 * (i / 20) / 19.0;
        rows.push_back(makeShadingPoint(dvec3(0, 0, 1), directionAt(NoV, 0), directionAt(0.5, 1), r));
    }
    const ProbeTerm E = makeAlbedoTerm();
    const Worst worst = worstOf(E, rows, [](const ShadingPoint&) { return 1e-4; });
    EXPECT_LE(worst.ratio, 1.0) << "error " << worst.error << " at " << described(rows[worst.row]);

    const std::vector<vec3> device =
        probe(test::device(), test::shaders(), makeProbeTerm(*findMethod(Slot::dfg, "table")), rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const dvec3 exact = DFG_table(rows[i].NoV, rows[i].perceptualRoughness);
        const double dielectric = exact.x * 0.04 + exact.y;
        EXPECT_NEAR((device[i].x * 0.04 + device[i].y) / dielectric, 1.0, 1e-4) << described(rows[i]);
        EXPECT_NEAR((1 - device[i].z) / (1 - exact.z), 1.0, 1e-4) << described(rows[i]); // the diffuse part is (1 - w)
    }
}

// Scalars at the ends of their ranges.
std::vector<ShadingPoint> corners()
{
    std::vector<ShadingPoint> rows;
    for (const double NoV : {-0.3, 0.0, 1e-38, 1e-20, 1e-6, 1.0})
        for (const double NoL : {-1.0, 0.0, 1e-38, 1e-20, 1e-6, 1.0})
            for (const double NoH : {0.0, 1e-20, 1e-3, 1.0})
                for (const double VoH : {0.0, 1e-20, 1e-3, 0.5, 1.0})
                    for (const double r : {0.0, 0.005, 0.01, 0.5, 1.0}) {
                        ShadingPoint p = makeShadingPoint(dvec3(0, 0, 1), dvec3(0, 0, 1), dvec3(0, 0, 1), r);
                        p.NoV = NoV;
                        p.NoL = NoL;
                        p.NoH = NoH;
                        p.VoH = std::max(VoH, 0.5 * (NoV + NoL)); // n.(v + l) <= |v + l| = 2 VoH
                        p.oneLessVoH = 1 - p.VoH;
                        p.VoL = 2 * p.VoH * p.VoH - 1;
                        p.sin2H = 1 - NoH * NoH;
                        for (const double index : {0.0, 0.5, 1.0, 1.5, 1e6}) {
                            p.ior = index;
                            p.eta = dvec3(index, index, 1.0);
                            p.k = dvec3(0.0, 1e6, 1e-30);
                            rows.push_back(p);
                        }
                    }
    return rows;
}

// METHODS.md: 0 * Inf at NoH -> 0, 0/0 where both cosines vanish, the square root of what should be 0, powers that
// underflow.
TEST_P(ScalarTerm, IsFiniteAndZeroBelowTheHorizonAtEveryCorner)
{
    const Method& method = *GetParam();
    const std::vector<ShadingPoint> rows = corners();
    const std::vector<vec3> device = probe(test::device(), test::shaders(), makeProbeTerm(method), rows);
    const bool needsHorizon = method.slot == Slot::visibility || method.slot == Slot::diffuse;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const vec3 value = device[i];
        ASSERT_TRUE(std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z)) << described(rows[i]);
        ASSERT_TRUE(value.x >= 0 && value.y >= 0 && value.z >= 0) << described(rows[i]);
        if (needsHorizon && (rows[i].NoV <= 0 || rows[i].NoL <= 0)) {
            ASSERT_EQ(value, vec3(0)) << described(rows[i]);
        }
        if (method.slot == Slot::fresnel) {
            ASSERT_LE(std::max({value.x, value.y, value.z}), 1.0f + 1e-6f) << described(rows[i]);
        }
    }
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
    ShadingPoint p;
    for (const double VoH : {0.0, 1e-20, 0.01, 0.5, 1.0}) {
        p.VoH = VoH;
        p.ior = 1;
        p.eta = dvec3(1);
        p.k = dvec3(0);
        EXPECT_EQ(onDevice(dielectric, p), vec3(0)) << VoH;
        EXPECT_EQ(onDevice(conductor, p), vec3(0)) << VoH;
        p.ior = 0;
        EXPECT_EQ(onDevice(dielectric, p), vec3(1)) << VoH;
    }
    p.VoH = 0.3; // cos of the critical angle for 0.75 is 0.66
    p.ior = 0.75;
    EXPECT_EQ(onDevice(dielectric, p), vec3(1)) << "beyond the critical angle";
}

} // namespace
} // namespace torrance
