// Fronts whose members are known by inspection, and of random points against the definition.
#include "measure/pareto.h"

#include "math/number_stream.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace torrance {
namespace {

using Indices = std::vector<std::size_t>;

bool dominates(const CostAndError& a, const CostAndError& b)
{
    return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

TEST(Pareto, KeepsWhatNothingCheaperIsAsGoodAs)
{
    const std::vector<CostAndError> points = {{3, 1}, {1, 9}, {2, 9}, {2, 4}, {4, 1}, {5, 0}};
    EXPECT_EQ(paretoFront(points), (Indices{1, 3, 0, 5})) << "(2, 9) costs more than (1, 9), (4, 1) more than (3, 1)";
}

TEST(Pareto, KeepsEqualsAndOneAlone)
{
    EXPECT_EQ(paretoFront(std::vector<CostAndError>{{1, 1}, {1, 1}, {1, 2}}), (Indices{0, 1}));
    EXPECT_EQ(paretoFront(std::vector<CostAndError>{{7, 7}}), (Indices{0}));
    EXPECT_TRUE(paretoFront({}).empty());
}

TEST(Pareto, LeavesOutWhatIsNotKnown)
{
    EXPECT_EQ(paretoFront(std::vector<CostAndError>{{1, NAN}, {NAN, 0}, {2, HUGE_VAL}}), (Indices{2}));
}

TEST(Pareto, IsTheDefinitionOnRandomPoints)
{
    NumberStream numbers(1);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<CostAndError> points;
        for (int i = 0; i < 12; ++i) // on a coarse grid: ties happen
            points.push_back({std::floor(6 * numbers.next()), std::floor(6 * numbers.next())});
        Indices expected;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (std::ranges::none_of(points, [&](const CostAndError& other) { return dominates(other, points[i]); }))
                expected.push_back(i);
        Indices front = paretoFront(points);
        EXPECT_TRUE(std::ranges::is_sorted(front, {}, [&](std::size_t i) { return points[i].cost; }));
        std::ranges::sort(front);
        EXPECT_EQ(front, expected);
    }
}

} // namespace
} // namespace torrance
