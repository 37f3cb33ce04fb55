#include "program.h"

#include <fstream>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

TEST(Stability, WritesMapsTableAndReportTheSameWhateverTheThreads)
{
    const TestFolder folder;
    std::vector<std::string> reports;
    for (const std::string threads : {"1", "2"}) {
        const Outcome outcome = runTorrance({"stability", "--method", "distribution/ggx_textbook", "--size", "12",
                                             "--precision", "fp32", "-o", folder.file(threads)},
                                            {"TORRANCE_THREADS=" + threads});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
        EXPECT_NE(outcome.output.find("fp32: error passes 1e-2 within roughness <= "), std::string::npos)
            << outcome.output;
        EXPECT_EQ(contentOf(folder.file(threads) + "/distribution_ggx_textbook_fp32.png").substr(1, 3), "PNG");
        EXPECT_TRUE(contentOf(folder.file(threads) + "/distribution_ggx_textbook.csv")
                        .starts_with("what,NoV,roughness,error,excess,"));
        reports.push_back(contentOf(folder.file(threads) + "/index.html"));
    }
    EXPECT_NE(reports.front().find("href=\"distribution_ggx_textbook.csv\""), std::string::npos);
    EXPECT_EQ(reports.front(), reports.back());
}

// The lantern's holes and the leaves are finer than the pixels of so small a picture: they sparkle. All else holds.
TEST(Stability, FailsForAPictureThatDoesNotResolveItsScene)
{
    const TestFolder folder;
    const Outcome outcome = runTorrance({"stability", "demo", "-r", "64x64", "-o", folder.file("report")});
    EXPECT_EQ(outcome.exitCode, 1) << outcome.errors;
    const std::size_t failure = outcome.output.find("FAIL  ");
    EXPECT_EQ(outcome.output.find("FAIL  camera moved by parts of a pixel"), failure) << outcome.output;
    EXPECT_EQ(outcome.output.find("FAIL  ", failure + 1), std::string::npos) << outcome.output;
    const std::string report = contentOf(folder.file("report") + "/scene.html");
    EXPECT_NE(report.find("everything moved by 1e6 m"), std::string::npos);
    EXPECT_NE(report.find(">FAIL<"), std::string::npos);
}

TEST(Stability, RefusesWhatItCannotSweep)
{
    const Outcome unknown = runTorrance({"stability", "--method", "gxx"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_TRUE(isOneLine(unknown.errors)) << unknown.errors;
    EXPECT_NE(unknown.errors.find("did you mean ggx?"), std::string::npos) << unknown.errors;
    EXPECT_EQ(runTorrance({"stability", "--method", "srgb"}).exitCode, 2) << "has no function of a shading point";
    EXPECT_EQ(runTorrance({"stability", "--precision", "fp8"}).exitCode, 2);
    EXPECT_EQ(runTorrance({"stability", "demo", "--method", "ggx"}).exitCode, 2);
    EXPECT_EQ(runTorrance({"stability", "absent.glb"}).exitCode, 3);
    EXPECT_EQ(runTorrance({"stability", "demo", "demo"}).exitCode, 2) << "one scene at a time";
    const TestFolder folder;
    std::ofstream(folder.file("file")) << "x";
    const Outcome blocked = runTorrance({"stability", "--method", "implicit", "-o", folder.file("file")});
    EXPECT_EQ(blocked.exitCode, 6);
    EXPECT_TRUE(isOneLine(blocked.errors)) << blocked.errors;
}

} // namespace
} // namespace torrance::test
