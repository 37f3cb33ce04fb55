// The table against the quadrature that it stands in for, off its nodes.
#include "brdf/lobe_albedo_table.h"

#include "brdf/lobe_albedo.h"
#include "math/number_stream.h"

#include <cmath>
#include <gtest/gtest.h>
#include <thread>
#include <vector>

namespace torrance::brdf {
namespace {

double relativeError(double NoV, double r)
{
    return std::abs(lobeAlbedoFromTable(NoV, r) / lobeTerms(NoV, r).albedo() - 1.0);
}

// Half of the roughnesses and of the cosines spread over their decades, half evenly.
TEST(LobeAlbedoTable, IsTheQuadrature)
{
    NumberStream numbers(7);
    for (int i = 0; i < 4000; ++i) {
        const double even = numbers.next(), decades = numbers.next();
        const double r = i % 2 == 0 ? even : std::pow(10.0, -2.5 * even);
        const double NoV = i % 4 < 2 ? decades : std::pow(10.0, -4.0 * decades);
        EXPECT_LT(relativeError(NoV, r), NoV >= 1e-4 ? 1e-6 : 1e-5) << NoV << ' ' << r;
    }
}

// The bias is a part of E, and is held to E's size: alone it is next to nothing where the surface is smooth.
TEST(LobeAlbedoTable, BiasIsTheQuadraturesBias)
{
    NumberStream numbers(8);
    for (int i = 0; i < 1000; ++i) {
        const double r = numbers.next(), NoV = i % 2 == 0 ? numbers.next() : std::pow(10.0, -4.0 * numbers.next());
        const AlbedoTerms terms = lobeTermsFromTable(NoV, r), exact = lobeTerms(NoV, r);
        EXPECT_NEAR(terms.bias, exact.bias, 1e-6 * exact.albedo()) << NoV << ' ' << r;
        EXPECT_NEAR(terms.albedo(), lobeAlbedoFromTable(NoV, r), 1e-15) << NoV << ' ' << r;
    }
}

TEST(LobeAlbedoTable, HoldsAtTheEdges)
{
    for (const double r : {0.0, 1e-3, 0.01, 0.0101, 0.5, 0.999, 1.0}) {
        for (const double NoV : {1e-4, 2e-4, 1e-3, 0.5, 0.999, 1.0})
            EXPECT_LT(relativeError(NoV, r), 1e-6) << NoV << ' ' << r;
        for (const double NoV : {0.0, 1e-9, 1e-7, 1e-6, 3e-6, 1e-5, 5e-5})
            EXPECT_LT(relativeError(NoV, r), 1e-5) << NoV << ' ' << r;
    }
}

TEST(LobeAlbedoTable, MeanIsTheQuadraturesMean)
{
    for (const double r : {0.0, 0.005, 0.013, 0.047, 0.11, 0.29, 0.51, 0.77, 0.93, 0.996, 1.0})
        EXPECT_NEAR(averageLobeAlbedoFromTable(r) / averageLobeAlbedo(r), 1.0, 1e-6) << r;
}

// Whether a node is there already, and who computed it, must not show.
TEST(LobeAlbedoTable, GivesTheSameBitsToAllThreads)
{
    const auto values = [](bool backwards) {
        std::vector<double> found(200);
        for (int n = 0; n < 200; ++n) {
            const int i = backwards ? 199 - n : n;
            found[i] = lobeAlbedoFromTable((i + 0.5) / 200.0, 0.61);
        }
        return found;
    };
    std::vector<double> forth, back;
    std::thread one([&] { forth = values(false); }), other([&] { back = values(true); });
    one.join();
    other.join();
    EXPECT_EQ(forth, back);
    EXPECT_EQ(forth, values(false));
}

} // namespace
} // namespace torrance::brdf
