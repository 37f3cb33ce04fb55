// What every command shares: help, version, exit codes, and errors of one line that name the remedy.
#include "program.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

TEST(CommandLine, VersionNamesTheBuild)
{
    const Outcome outcome = runTorrance({"--version"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.output.rfind("torrance ", 0), 0u) << outcome.output;
    EXPECT_EQ(outcome.errors, "");
}

TEST(CommandLine, VersionNamesTheVulkanDriver)
{
    EXPECT_NE(runTorrance({"--version"}).output.find("\nVulkan 1."), std::string::npos);
    const Outcome without =
        runTorrance({"--version"}, {"VK_DRIVER_FILES=/nonexistent", "VK_ICD_FILENAMES=/nonexistent"});
    EXPECT_EQ(without.exitCode, 0) << "the version can be asked for on any machine";
    EXPECT_NE(without.output.find("\nVulkan: no "), std::string::npos) << without.output;
}

TEST(CommandLine, NoCommandIsAUsageError)
{
    const Outcome outcome = runTorrance({});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    EXPECT_NE(outcome.errors.find("--help"), std::string::npos) << outcome.errors;
}

TEST(CommandLine, HelpGoesToStandardOutput)
{
    const Outcome outcome = runTorrance({"--help"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_NE(outcome.output.find("--no-cache"), std::string::npos) << outcome.output;
    EXPECT_EQ(outcome.errors, "");
}

} // namespace
} // namespace torrance::test
