#include "program.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

TEST(RenderPath, IsChosenAndExplained)
{
    const TestFolder folder;
    const Outcome deferred =
        runTorrance({"render", "demo", "-r", "32x24", "--path", "deferred", "--explain", "-o", folder.file("a.exr")});
    EXPECT_EQ(deferred.exitCode, 0) << deferred.errors;
    EXPECT_NE(deferred.output.find("path: deferred, "), std::string::npos) << deferred.output;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.exr"});
}

TEST(RenderPath, TriangleCullingIsChosenAndExplained)
{
    const TestFolder folder;
    for (const char* choice : {"on", "off"}) {
        const Outcome outcome = runTorrance({"render", "demo", "-r", "32x24", "--triangle-culling", choice, "--explain",
                                             "-o", folder.file(std::string(choice) + ".exr")});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
        EXPECT_EQ(outcome.output.find("(--triangle-culling on)") != std::string::npos, choice == std::string("on"))
            << outcome.output;
    }
    const Outcome refused = runTorrance({"render", "demo", "--triangle-culling", "yes", "-o", folder.file("a.png")});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_TRUE(isOneLine(refused.errors)) << refused.errors;
}

TEST(RenderPath, RefusesOthers)
{
    const Outcome outcome = runTorrance({"render", "demo", "--path", "defered", "-o", "a.png"});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    EXPECT_NE(outcome.errors.find("deferred"), std::string::npos) << outcome.errors;
}

} // namespace
} // namespace torrance::test
