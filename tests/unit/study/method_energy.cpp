#include "study/method_energy.h"

#include "brdf/albedo.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

using brdf::findMethod;
using brdf::Slot;

double energy(Slot slot, std::string_view id, double NoV, double r)
{
    return returnedEnergy(*findMethod(slot, id), NoV, r).value();
}

constexpr double kHalfSlack = kEnergySlack / 2;

TEST(ReturnedEnergy, OfADistributionIsTheAreaOfItsFacetsSeenFromAbove)
{
    for (const double r : {0.0, 0.1, 0.5, 1.0}) {
        EXPECT_NEAR(energy(Slot::distribution, "ggx", 0.5, r), 1.0, 1e-9) << r;
        EXPECT_NEAR(energy(Slot::distribution, "beckmann", 0.5, r), 1.0, kHalfSlack) << r;
    }
}

// albedo.h integrates the same lobe in other variables.
TEST(ReturnedEnergy, OfTheCorrelatedSmithTermIsTheDirectionalAlbedo)
{
    for (const double NoV : {1e-4, 0.01, 0.1, 0.5, 1.0})
        for (const double r : {0.0, 0.1, 0.4, 0.7, 1.0})
            EXPECT_NEAR(energy(Slot::visibility, "smith_corr", NoV, r), brdf::ggxAlbedo(NoV, r).albedo(), kHalfSlack)
                << NoV << " " << r;
}

TEST(ReturnedEnergy, OfDiffuseTermsWithAlbedoOneIsOne)
{
    for (const double NoV : {1e-4, 0.1, 0.5, 1.0})
        for (const double r : {0.0, 0.5, 1.0}) {
            EXPECT_NEAR(energy(Slot::diffuse, "lambert", NoV, r), 1.0, 1e-9);
            EXPECT_NEAR(energy(Slot::diffuse, "eon", NoV, r), 1.0, kHalfSlack) << NoV << " " << r;
        }
}

TEST(ReturnedEnergy, OfCompensationIsOneForAWhiteMetal)
{
    EXPECT_NEAR(energy(Slot::multipleScattering, "scale", 0.3, 0.9), 1.0, 1e-12);
    EXPECT_NEAR(energy(Slot::multipleScattering, "none", 0.3, 0.9), brdf::ggxAlbedo(0.3, 0.9).albedo(), 1e-12);
}

TEST(ReturnedEnergy, IsNothingToAFresnelTerm)
{
    EXPECT_FALSE(returnedEnergy(*findMethod(Slot::fresnel, "schlick"), 0.5, 0.5));
}

TEST(Reciprocity, HoldsForSmithAndNotForCompensationAtOneOfTheDirections)
{
    EXPECT_LT(reciprocityError(*findMethod(Slot::visibility, "smith_corr"), 0.2, 0.5).value(), 1e-9);
    // 1/E(0.2) against 1/E(0.6)
    const double there = brdf::ggxAlbedo(0.2, 0.9).albedo(), again = brdf::ggxAlbedo(0.6, 0.9).albedo();
    EXPECT_NEAR(reciprocityError(*findMethod(Slot::multipleScattering, "scale"), 0.2, 0.9).value(),
                1 - std::min(there, again) / std::max(there, again), 1e-9);
}

} // namespace
} // namespace torrance
