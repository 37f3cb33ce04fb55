// The source systems on the command line: what beside them would have no meaning is refused in one line.
#include "program.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

class Sources : public ::testing::Test
{
protected:
    void refused(const std::vector<std::string>& more, const std::string& word)
    {
        std::vector<std::string> arguments = {"render", "demo", "-r", "16x16", "-o", folder.file("out.png")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = runTorrance(arguments);
        EXPECT_EQ(outcome.exitCode, 2) << outcome.errors;
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
        EXPECT_NE(outcome.errors.find(word), std::string::npos) << outcome.errors;
        EXPECT_TRUE(folder.names().empty());
    }

    TestFolder folder;
};

TEST_F(Sources, RefuseMethodsOfTheirOwnSlots)
{
    refused({"--preset", "ue4-direct", "--distribution", "ggx"}, "--distribution");
    refused({"--model", "ue4_direct", "--multiple-scattering", "scale"}, "--multiple-scattering");
    refused({"--preset", "ue4-direct", "--model", "gltf"}, "--model");
}

TEST_F(Sources, RefuseQuirksAndParametersThatTheyDoNotHave)
{
    refused({"--preset", "smith-r", "--quirk", "double-fresnel"}, "it has none");
    refused({"--preset", "schlick-beckmann", "--quirk", "no-cosine"}, "known are double-fresnel");
    refused({"--preset", "phong", "--parameter", "shine=3"}, "known are ambient, specular");
    refused({"--preset", "phong", "--parameter", "ambient=2"}, "between 0 and 1");
    refused({"--preset", "phong", "--parameter", "ambient"}, "--parameter ambient");
    refused({"--quirk", "double-fresnel"}, "the preset standard has no quirk");
}

TEST_F(Sources, RefuseAnEnvironmentThatTheyDoNotDefine)
{
    refused({"--preset", "ue4-direct", "--environment", "studio"}, "--environment none");
    refused({"--preset", "ue4-direct", "--environment-intensity", "2"}, "nothing to turn or to scale");
}

} // namespace
} // namespace torrance::test
