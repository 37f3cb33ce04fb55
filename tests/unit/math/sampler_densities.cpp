// Every sampler against its density.
#include "chi_square.h"
#include "math/frame.h"
#include "math/sampling.h"
#include "math/scrambled_sequence.h"

#include <gtest/gtest.h>
#include <string>

namespace torrance::test {
namespace {

constexpr int kSamples = 200000;

struct Surface
{
    dvec3 view;
    dvec2 alpha;
    std::string name;
};

/// Head on to grazing, round and stretched, smooth to the roughest.
std::vector<Surface> surfaces()
{
    std::vector<Surface> list;
    for (const double NoV : {1.0, 0.7, 0.25, 0.02})
        for (const dvec2 alpha : {dvec2(1.0), dvec2(0.4), dvec2(0.7, 0.25), dvec2(0.15)}) {
            const double sine = std::sqrt(1.0 - NoV * NoV);
            list.push_back(
                {dvec3(sine * std::cos(0.8), sine * std::sin(0.8), NoV), alpha,
                 "NoV " + std::to_string(NoV) + " alpha " + std::to_string(alpha.x) + " " + std::to_string(alpha.y)});
        }
    return list;
}

const auto everywhere = [](const dvec3&) { return true; };
const auto aboveTheHorizon = [](const dvec3& d) { return d.z > 0.0; };

void expectFollows(const SamplerJudgement& judgement, const std::string& name, std::size_t families)
{
    EXPECT_GE(judgement.likelihood, kFamilyLevel / static_cast<double>(families)) << name;
}

TEST(ChiSquare, TailHasItsClosedForms)
{
    // Two degrees: exp(-x / 2). Four: (1 + x / 2) exp(-x / 2). One: erfc(sqrt(x / 2)).
    for (const double x : {0.1, 1.0, 3.0, 20.0, 100.0}) {
        EXPECT_NEAR(chiSquareTail(x, 2) / std::exp(-0.5 * x), 1.0, 1e-12);
        EXPECT_NEAR(chiSquareTail(x, 4) / ((1.0 + 0.5 * x) * std::exp(-0.5 * x)), 1.0, 1e-12);
        EXPECT_NEAR(chiSquareTail(x, 1) / std::erfc(std::sqrt(0.5 * x)), 1.0, 1e-9);
    }
}

TEST(ChiSquare, SeesADensityThatIsOnePerCentTooNarrow)
{
    const dvec3 view(0.6, 0.0, 0.8);
    const SamplerJudgement judgement = judgeSampler(
        [&](const dvec2& u) { return sampleGgxVisibleNormal(view, dvec2(0.396), u); },
        [&](const dvec3& h) { return ggxVisibleNormalDensity(view, dvec2(0.4), h); }, everywhere, 10 * kSamples, 3);
    EXPECT_LT(judgement.likelihood, 1e-6);
}

TEST(SamplerDensities, CosineHemisphere)
{
    const SamplerJudgement judgement = judgeSampler(sampleCosine, cosineDensity, everywhere, 10 * kSamples, 1);
    EXPECT_NEAR(judgement.integral, 1.0, 1e-12);
    expectFollows(judgement, "cosine", 1);
}

TEST(SamplerDensities, Cone)
{
    for (const double oneLessCosine : {0.01, 0.5, 1.0, 2.0}) {
        const double area = 2.0 * kPi * oneLessCosine;
        // The cone's edge cuts through cells: those get their share by area instead of by quadrature.
        const SphereCells cells;
        const double edge = std::acos(1.0 - oneLessCosine);
        std::vector<double> expected;
        for (int row = 0; row < cells.rows; ++row) {
            const double top = std::min(edge, kPi * row / cells.rows),
                         low = std::min(edge, kPi * (row + 1) / cells.rows);
            const double share = (std::cos(top) - std::cos(low)) * 2.0 * kPi / cells.columns / area;
            expected.insert(expected.end(), static_cast<std::size_t>(cells.columns), share * kSamples);
        }
        std::vector<double> counts(cells.count(), 0.0);
        std::mt19937_64 generator(7);
        std::uniform_real_distribution<double> uniform;
        for (int i = 0; i < kSamples; ++i) {
            const double x = uniform(generator), y = uniform(generator);
            counts[cells.of(sampleCone(oneLessCosine, {x, y}))] += 1.0;
        }
        EXPECT_GE(chiSquareLikelihood(expected, counts), kFamilyLevel / 4) << oneLessCosine;
    }
}

TEST(SamplerDensities, GgxNormals)
{
    for (const dvec2 alpha : {dvec2(1.0), dvec2(0.4), dvec2(0.7, 0.25), dvec2(0.15)}) {
        const SamplerJudgement judgement = judgeSampler(
            [&](const dvec2& u) { return sampleGgxNormal(alpha, u); },
            [&](const dvec3& h) { return ggxNormalDensity(alpha, h) * h.z; }, aboveTheHorizon, kSamples, 2);
        EXPECT_NEAR(judgement.integral, 1.0, 1e-6);
        expectFollows(judgement, "alpha " + std::to_string(alpha.x), 4);
    }
}

TEST(SamplerDensities, VisibleNormalsBySphericalCaps)
{
    for (const Surface& s : surfaces()) {
        const SamplerJudgement judgement = judgeSampler(
            [&](const dvec2& u) { return sampleGgxVisibleNormal(s.view, s.alpha, u); },
            [&](const dvec3& h) { return ggxVisibleNormalDensity(s.view, s.alpha, h); }, aboveTheHorizon, kSamples, 3);
        EXPECT_NEAR(judgement.integral, 1.0, 1e-4) << s.name; // the rule meets a kink at v . h = 0
        expectFollows(judgement, s.name, surfaces().size());
    }
}

TEST(SamplerDensities, VisibleNormalsByHeitz)
{
    for (const Surface& s : surfaces())
        expectFollows(judgeSampler([&](const dvec2& u) { return sampleGgxVisibleNormalHeitz(s.view, s.alpha, u); },
                                   [&](const dvec3& h) { return ggxVisibleNormalDensity(s.view, s.alpha, h); },
                                   aboveTheHorizon, kSamples, 4),
                      s.name, surfaces().size());
}

TEST(SamplerDensities, BoundedReflections)
{
    for (const Surface& s : surfaces()) {
        const SamplerJudgement judgement = judgeSampler(
            [&](const dvec2& u) { return sampleGgxReflection(s.view, s.alpha, u); },
            [&](const dvec3& l) { return ggxReflectionDensity(s.view, s.alpha, l); }, aboveTheHorizon, kSamples, 5);
        EXPECT_LE(judgement.integral, 1.0 + 1e-6) << s.name;
        expectFollows(judgement, s.name, surfaces().size());
    }
}

// What the bound is for: the share of reflections above the horizon is at least that of the unbounded caps.
TEST(SamplerDensities, TheBoundLosesFewerReflectionsToTheGround)
{
    for (const Surface& s : surfaces()) {
        const auto lost = [&](const auto& reflection) {
            int below = 0;
            const ScrambledSequence points(11);
            for (std::uint32_t i = 0; i < 4096; ++i)
                below += reflection(points[i]).z <= 0.0;
            return below;
        };
        const int bounded = lost([&](const dvec2& u) { return sampleGgxReflection(s.view, s.alpha, u); });
        const int whole = lost([&](const dvec2& u) {
            const dvec3 h = sampleGgxVisibleNormal(s.view, s.alpha, u);
            return 2.0 * glm::dot(s.view, h) * h - s.view;
        });
        EXPECT_LE(bounded, whole) << s.name;
        if (s.alpha == dvec2(1.0)) {
            EXPECT_EQ(bounded, 0) << s.name << ": alpha 1 leaves the upper half of the cap alone";
        }
    }
}

TEST(Frame, IsRightHandedAndOrthonormalEverywhere)
{
    for (const dvec3& direction : {dvec3(0, 0, 1), dvec3(0, 0, -1), dvec3(1, 0, 0), dvec3(0.3, -0.2, -0.9),
                                   dvec3(1e-9, 0, -1), dvec3(-0.5, 0.7, 0.1)})
    {
        const dvec3 n = glm::normalize(direction);
        const dmat3 frame = frameAround(n);
        EXPECT_EQ(frame[2], n);
        EXPECT_NEAR(glm::determinant(frame), 1.0, 1e-14);
        const dmat3 product = glm::transpose(frame) * frame;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                EXPECT_NEAR(product[i][j], i == j ? 1.0 : 0.0, 1e-14);
    }
}

} // namespace
} // namespace torrance::test
