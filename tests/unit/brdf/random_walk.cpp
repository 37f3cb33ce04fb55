#include "brdf/random_walk.h"

#include "../math/confidence.h"
#include "brdf/albedo.h"
#include "brdf/distribution.h"
#include "brdf/visibility.h"
#include "math/sampling.h"
#include "math/scrambled_sequence.h"
#include "points.h"

#include <functional>

namespace torrance::brdf {
namespace {

constexpr FacetInterface kMirror = {.ior = 0.0}; // reflects all, in channel a

/// Replicates of the mean of `estimate`, in the first channel.
Replicates meanOf(int draws, const std::function<double(const dvec2&, NumberStream&)>& estimate)
{
    Replicates replicates;
    for (std::size_t r = 0; r < kReplicates; ++r) {
        const ScrambledSequence points(hashNumbers({3, r}));
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(draws); ++i) {
            NumberStream numbers(hashNumbers({4, r, i}));
            replicates.values[r].r += estimate(points[i], numbers) / draws;
        }
    }
    return replicates;
}

/// Head on to grazing, smooth to rough.
const std::vector<std::pair<double, double>> kCases = {{1.0, 1.0}, {1.0, 0.3}, {0.5, 0.7}, {0.15, 1.0}, {0.1, 0.2}};

// The first reflection is single scattering: D, and V with correlated masking and shadowing, which the walk knows
// nothing of.
TEST(RandomWalk, FirstOrderIsTheMicrofacetBrdf)
{
    for (const auto& [NoV, alpha] : kCases)
        for (const double NoL : {0.9, 0.2}) {
            const ShadingPoint point = pointAt(NoV, NoL, 2.5, std::sqrt(alpha));
            const double exact = D_ggx(point) * V_smith_corr(point) * point.NoL;
            const Replicates once = meanOf(8192, [&](const dvec2&, NumberStream& numbers) {
                NumberStream again = numbers;
                return walkResponse(point.v, point.l, alpha, kMirror, 1, numbers).a -
                       walkResponse(point.v, point.l, alpha, kMirror, 2, again).a;
            });
            EXPECT_TRUE(test::agrees(once, dvec3(exact, 0.0, 0.0), 1e-12, 10)) << NoV << ' ' << alpha << ' ' << NoL;
        }
}

// Nothing is lost between perfect mirrors: over all l the response adds up to 1 at every view and roughness.
TEST(RandomWalk, WhiteSurfacesReturnAllLight)
{
    for (const auto& [NoV, alpha] : kCases) {
        const dvec3 v = directionAt(NoV, 0.4);
        const Replicates energy = meanOf(16384, [&](const dvec2& u, NumberStream& numbers) {
            const bool lobe = numbers.next() < 0.5;
            const dvec3 l = lobe ? sampleGgxReflection(v, dvec2(alpha), u) : sampleCosine(u);
            if (l.z <= 0.0)
                return 0.0;
            const double density = 0.5 * (ggxReflectionDensity(v, dvec2(alpha), l) + cosineDensity(l));
            return walkResponse(v, l, alpha, kMirror, 1, numbers).a / density;
        });
        EXPECT_TRUE(test::agrees(energy, dvec3(1.0, 0.0, 0.0), 0.0, kCases.size())) << NoV << ' ' << alpha;
        NumberStream numbers(1);
        EXPECT_EQ(walkAlbedo(v, alpha, kMirror, numbers).a, 1.0);
    }
}

TEST(RandomWalk, WhatIsReflectedOnceIsTheLobesAlbedo)
{
    // Single scattering of a white surface keeps E (albedo.h); so 1 - E is what comes from the second order on.
    for (const auto& [NoV, alpha] : kCases) {
        const dvec3 v = directionAt(NoV, 0.4);
        const Replicates rest = meanOf(16384, [&](const dvec2& u, NumberStream& numbers) {
            const dvec3 l = sampleCosine(u);
            return walkResponse(v, l, alpha, kMirror, 2, numbers).a / cosineDensity(l);
        });
        EXPECT_TRUE(
            test::agrees(rest, dvec3(1.0 - ggxAlbedo(NoV, std::sqrt(alpha)).albedo(), 0.0, 0.0), 1e-6, kCases.size()))
            << NoV << ' ' << alpha;
    }
}

// f(v, l) = f(l, v), though a walk from v joined to l and one from l joined to v have little in common.
TEST(RandomWalk, IsReciprocal)
{
    const FacetInterface gold = {.eta = dvec3(0.2, 0.4, 1.3), .k = dvec3(3.9, 2.4, 1.8), .ior = 1.5};
    for (const auto& [NoV, alpha] : kCases)
        for (const double NoL : {0.8, 0.25}) {
            const dvec3 v = directionAt(NoV, 0.4), l = directionAt(NoL, 2.0);
            Replicates difference;
            for (std::size_t r = 0; r < kReplicates; ++r)
                for (std::uint64_t i = 0; i < 2048; ++i) {
                    NumberStream forth(hashNumbers({6, r, i})), back(hashNumbers({7, r, i}));
                    difference.values[r] += dvec3(walkResponse(v, l, alpha, gold, 2, forth)) / (l.z * 2048.0) -
                                            dvec3(walkResponse(l, v, alpha, gold, 2, back)) / (v.z * 2048.0);
                }
            EXPECT_TRUE(test::agrees(difference, dvec3(0.0), 0.0, 10)) << NoV << ' ' << alpha << ' ' << NoL;
        }
}

TEST(RandomWalk, AlbedoIsTheIntegralOfTheResponse)
{
    const FacetInterface glass = {.ior = 1.5};
    for (const auto& [NoV, alpha] : kCases) {
        const dvec3 v = directionAt(NoV, 0.4);
        const Replicates difference = meanOf(8192, [&](const dvec2& u, NumberStream& numbers) {
            const double left = walkAlbedo(v, alpha, glass, numbers).a;
            const bool cosine = numbers.next() < 0.5;
            const dvec3 l = cosine ? sampleCosine(u) : sampleGgxReflection(v, dvec2(alpha), u);
            if (l.z <= 0.0)
                return -left;
            const double density = 0.5 * (ggxReflectionDensity(v, dvec2(alpha), l) + cosineDensity(l));
            return walkResponse(v, l, alpha, glass, 1, numbers).a / density - left;
        });
        EXPECT_TRUE(test::agrees(difference, dvec3(0.0), 0.0, kCases.size())) << NoV << ' ' << alpha;
    }
}

} // namespace
} // namespace torrance::brdf
