// The methods of the slot multiple_scattering against light that walks from facet to facet: the physics yardstick.
#include "brdf/fresnel.h"
#include "brdf/lobe_albedo.h"
#include "brdf/random_walk.h"
#include "points.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

/// What a method adds to the lobe's albedo, in closed form (multiple_scattering.h).
dvec3 addedBy(const Method& method, double NoV, double r, const dvec3& f0)
{
    ShadingPoint point = pointAt(NoV, 0.5, 0.0, r);
    setLobeAlbedo(point);
    point.f0 = f0;
    point.single = f0 * (point.E - point.bias) + point.bias;
    point.spread = dvec3(1);
    point.ELight = point.EAverage;
    return valueOf(method, point) - point.single;
}

/// Indices of aluminium, iron and gold in blue light: F0 = 0.91, 0.56 and 0.33.
constexpr FacetInterface kMetals{.eta = dvec3(1.5, 2.9, 1.44), .k = dvec3(7.8, 3.1, 1.6)};

struct Truth
{
    double r, NoV;
    dvec3 mean, error;
};

/// Albedo of what is reflected twice or more, light directions drawn by the cosine.
std::vector<Truth> walkedTruths()
{
    constexpr int kWalks = 40000;
    std::vector<Truth> truths;
    for (const double r : {0.5, 0.8, 1.0})
        for (const double NoV : {0.1, 0.5, 1.0}) {
            NumberStream numbers(7);
            dvec3 sum(0), squares(0);
            for (int i = 0; i < kWalks; ++i) {
                const double NoL = std::sqrt(numbers.next());
                const dvec3 l = directionAt(NoL, 2.0 * kPi * numbers.next());
                const dvec3 light =
                    dvec3(walkResponse(directionAt(NoV, 0.0), l, r * r, kMetals, 2, numbers)) * kPi / NoL;
                sum += light;
                squares += light * light;
            }
            const dvec3 mean = sum / double(kWalks);
            truths.push_back({r, NoV, mean, glm::sqrt((squares / double(kWalks) - mean * mean) / double(kWalks))});
        }
    return truths;
}

/// How far from the walk a method may lie, of light of 1: what DECISIONS.md states. `none` misses all of it, half of
/// aluminium's light.
struct Figure
{
    std::string_view id;
    double farthest;
};
constexpr Figure kFigures[] = {{"none", 0.6}, {"scale", 0.075}, {"kulla_conty", 0.03}, {"fdez_aguera", 0.035}};

// Whoever compensates misses less than half of what is missed without.
TEST(CompensationTruth, MethodsAreWithinTheirFiguresOfTheWalk)
{
    constexpr double kErrors = 4.5; // standard errors: a right mean lies farther out once in 1.5e5
    const dvec3 f0(facetReflectance(kMetals, 1.0));
    const std::vector<Truth> truths = walkedTruths();
    for (const Method& method : allMethods()) {
        if (method.slot != Slot::multipleScattering)
            continue;
        const auto* figure = std::ranges::find(kFigures, method.id, &Figure::id);
        ASSERT_NE(figure, std::end(kFigures)) << method.id << " needs a figure";
        for (const Truth& truth : truths) {
            const dvec3 added = addedBy(method, truth.NoV, truth.r, f0);
            for (int c = 0; c < 3; ++c) {
                const double missed = std::abs(added[c] - truth.mean[c]) - kErrors * truth.error[c];
                EXPECT_LE(missed, figure->farthest) << method.id << ' ' << truth.r << ' ' << truth.NoV << ' ' << c;
                if (method.readsAlbedo) {
                    EXPECT_LT(missed, 0.5 * truth.mean[c]) << method.id << ' ' << truth.r << ' ' << truth.NoV;
                }
            }
        }
    }
}

} // namespace
} // namespace torrance::brdf
