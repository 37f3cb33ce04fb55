#include "measure/student.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

TEST(Student, KnowsItsClosedForms)
{
    const double pi = std::acos(-1.0);
    for (const double t : {-50.0, -1.0, 0.0, 0.3, 2.0, 12.0}) {
        EXPECT_NEAR(studentCumulative(t, 1.0), 0.5 + std::atan(t) / pi, 1e-12) << "Cauchy's";
        EXPECT_NEAR(studentCumulative(t, 2.0), 0.5 + 0.5 * t / std::sqrt(2.0 + t * t), 1e-12);
        EXPECT_NEAR(studentCumulative(t, 4.0), 0.5 + 0.5 * t * (t * t + 6.0) / std::pow(t * t + 4.0, 1.5), 1e-12);
    }
}

// Abramowitz & Stegun, table 26.10, column 0.95 of A.
TEST(Student, KnowsTheTable)
{
    EXPECT_NEAR(student95(1), 12.706, 5e-4);
    EXPECT_NEAR(student95(5), 2.571, 5e-4);
    EXPECT_NEAR(student95(15), 2.131, 5e-4);
    EXPECT_NEAR(student95(120), 1.980, 5e-4);
    EXPECT_NEAR(student95(std::numeric_limits<double>::infinity()), 1.960, 5e-4);
    EXPECT_EQ(student95(0.1), student95(kLeastDegrees));
}

} // namespace
} // namespace torrance
