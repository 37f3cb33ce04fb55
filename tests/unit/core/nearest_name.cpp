#include "core/nearest_name.h"

#include <gtest/gtest.h>
#include <vector>

namespace torrance {
namespace {

TEST(NearestName, CountsOneEditPerSlip)
{
    EXPECT_EQ(editDistance("smith", "smith"), 0u);
    EXPECT_EQ(editDistance("smth", "smith"), 1u);
    EXPECT_EQ(editDistance("simth", "smith"), 1u) << "a swap of neighbours is one slip";
    EXPECT_EQ(editDistance("SMITH", "smith"), 0u) << "case is no slip";
    EXPECT_EQ(editDistance("", "abc"), 3u);
}

TEST(NearestName, SaysNothingWhereNothingIsNear)
{
    const std::vector<std::string> names = {"ggx", "beckmann", "blinn"};
    EXPECT_EQ(nearestName("bekmann", names), "beckmann");
    EXPECT_EQ(nearestName("ggz", names), "ggx");
    EXPECT_EQ(nearestName("oren_nayar", names), "");
}

} // namespace
} // namespace torrance
