#include "study/conformance_report.h"

#include <gtest/gtest.h>
#include <limits>

namespace torrance {
namespace {

ConformanceResult result(double excess, std::string fault = "")
{
    ConformanceResult r;
    r.name = "case";
    r.excess = excess;
    r.place = "pixel (3, 4)";
    r.worst = "drawn 1 exact 2";
    r.fault = std::move(fault);
    return r;
}

std::vector<ConformanceGroup> groupsOf(const ConformanceResult& r)
{
    return {{"spheres", "must be equal", {result(0.5), r}}};
}

TEST(Conformance, PassesUpToAllThatIsAllowed)
{
    EXPECT_TRUE(result(1.0).passed());
    EXPECT_FALSE(result(1.001).passed());
    EXPECT_FALSE(result(std::numeric_limits<double>::quiet_NaN()).passed());
    EXPECT_FALSE(result(0.0, "coverage").passed());
    EXPECT_FALSE(groupsOf(result(2.0))[0].passed());
}

TEST(Conformance, SaysWhyACaseFailed)
{
    EXPECT_EQ(shortFault(result(2.5)), "2.5 of what is allowed at pixel (3, 4)");
    EXPECT_EQ(shortFault(result(0.0, "validation: a\nvalidation: b")), "validation: a");
    const std::vector<JunitSuite> suites = conformanceSuites(groupsOf(result(2.5, "coverage")));
    ASSERT_EQ(suites.size(), 1u);
    EXPECT_EQ(suites[0].cases[0].result, CaseResult::passed);
    EXPECT_EQ(suites[0].cases[1].result, CaseResult::failed);
    EXPECT_EQ(suites[0].cases[1].message, "coverage");
    EXPECT_EQ(suites[0].cases[1].details, "must be equal\ncoverage\ndrawn 1 exact 2");
}

TEST(Conformance, ReportShowsTheWorstAndTheFailedPictures)
{
    ConformanceResult bad = result(2.5);
    bad.drawn = Image(4, 4, 4, 1.0f);
    bad.exact = Image(4, 4, 4, 0.5f);
    bad.difference = Image(4, 4, 1, 2.5f);
    gpu::DeviceDescription device;
    device.name = "a <device>";
    const std::string html = htmlText(conformanceReport(groupsOf(bad), device));
    EXPECT_NE(html.find("Conformance of a &lt;device&gt;"), std::string::npos);
    EXPECT_NE(html.find("<td class=\"bad\">FAIL</td><td>2.5</td><td>drawn 1 exact 2</td>"), std::string::npos);
    EXPECT_NE(html.find("<td class=\"good\">pass</td><td>0.5</td><td>pixel (3, 4)</td>"), std::string::npos);
    std::size_t pictures = 0;
    for (std::size_t at = html.find("<img"); at != std::string::npos; at = html.find("<img", at + 1))
        ++pictures;
    EXPECT_EQ(pictures, 6u) << "three sheets, three large";
}

} // namespace
} // namespace torrance
