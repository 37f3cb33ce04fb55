#include "program.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

TEST(Methods, ListsSlotsMethodsAndPresets)
{
    const Outcome outcome = runTorrance({"methods"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_NE(outcome.output.find("distribution\n  ggx "), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("Heitz 2014"), std::string::npos);
    EXPECT_NE(outcome.output.find("presets\n  standard "), std::string::npos);
}

TEST(Methods, TheGeneratedPageIsCurrent)
{
    const std::string measured = TORRANCE_SOURCE_DIR "/docs/measured.csv";
    EXPECT_EQ(runTorrance({"methods", "--markdown", "--measured", measured}).output,
              contentOf(TORRANCE_SOURCE_DIR "/docs/methods.md"))
        << "run: torrance methods --markdown --measured docs/measured.csv > docs/methods.md";
}

TEST(Methods, TakesMeasuredErrorsForItsTablesOnly)
{
    const std::string measured = TORRANCE_SOURCE_DIR "/docs/measured.csv";
    EXPECT_EQ(runTorrance({"methods", "--measured", measured}).exitCode, 2);
    EXPECT_EQ(runTorrance({"methods", "--markdown", "--measured", "absent.csv"}).exitCode, 3);
    EXPECT_EQ(runTorrance({"methods", "--markdown"}).output.find("| fp32 |"), std::string::npos);
}

TEST(Methods, WritesTheRegistryAsJson)
{
    const TestFolder folder;
    const Outcome toFile = runTorrance({"methods", "--json", folder.file("methods.json")});
    EXPECT_EQ(toFile.exitCode, 0);
    const std::string json = contentOf(folder.file("methods.json"));
    EXPECT_NE(json.find("\"glsl\": \"shaders/brdf/distribution/ggx.glsl\""), std::string::npos) << json;
    EXPECT_EQ(runTorrance({"--json", "-", "methods"}).output, json) << "alone on standard output";
}

} // namespace
} // namespace torrance::test
