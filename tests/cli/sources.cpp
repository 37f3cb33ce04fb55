// The source systems on the command line: what beside them would have no meaning is refused in one line.
#include "program.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

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
    refused({"--preset", "phong", "--parameter", "refraction=1.5"}, "between 0 and 1");
    refused({"--preset", "smith-r", "--parameter", "reflection=0.5"}, "it has none");
    refused({"--preset", "phong", "--quirk", "five-levels"}, "it has none");
    refused({"--preset", "phong", "--parameter", "ambient"}, "--parameter ambient");
    refused({"--quirk", "double-fresnel"}, "the preset standard has no quirk");
}

TEST_F(Sources, RefuseAnEnvironmentThatTheyDoNotDefine)
{
    for (const char* preset : {"ue4-direct", "cook-torrance-beckmann", "schlick-beckmann", "smith-r"})
        refused({"--preset", preset, "--environment", "studio"}, "--environment none");
    refused({"--preset", "ue4-direct", "--environment", "studio", "--view", "prefiltered"}, "--environment none");
    refused({"--preset", "ue4-direct", "--environment-intensity", "2"}, "nothing to turn or to scale");
}

TEST_F(Sources, RefuseAnEnvironmentThroughTheLevelsOfAnotherModel)
{
    refused({"--preset", "torrance-sparrow-blinn", "-e", "furnace", "--environment-specular", "split_sum"},
            "--environment-specular");
    refused({"--preset", "ggx-burley", "-e", "furnace", "--environment-specular", "mirror"}, "--environment-specular");
    for (const char* levels : {"phong_levels", "ggx_levels", "mirror"})
        refused({"-e", "furnace", "--environment-specular", levels}, "--environment-specular");
}

TEST_F(Sources, RefuseAnEnvironmentsMethodsWhereTheyHaveThemselves)
{
    refused({"--preset", "phong", "-e", "furnace", "--environment-diffuse", "sh9"}, "--environment-diffuse");
    refused({"--preset", "ggx-burley", "-e", "furnace", "--dfg", "karis_mobile"}, "--dfg");
    refused({"--preset", "phong", "-e", "furnace", "--view", "irradiance"}, "diffuse light from an environment");
}

// And --explain says what is looked up.
TEST_F(Sources, DrawTheEnvironmentThatTheyDefine)
{
    const auto explained = [&](const std::string& preset) {
        const std::string out = folder.file(preset + ".png");
        const Outcome outcome =
            runTorrance({"render", "demo", "-r", "16x16", "--preset", preset, "-e", "furnace", "--explain", "-o", out});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
        EXPECT_TRUE(std::filesystem::exists(out)) << preset;
        return outcome.output;
    };
    const std::string phong = explained("phong"), burley = explained("ggx-burley"), none = "albedo table: left out";
    EXPECT_NE(phong.find("environment_specular: mirror"), std::string::npos) << phong;
    EXPECT_NE(phong.find("parameter fresnel-exponent: 2"), std::string::npos) << phong;
    EXPECT_NE(phong.find(none), std::string::npos) << phong;
    EXPECT_NE(burley.find("environment_specular: ggx_levels"), std::string::npos) << burley;
    EXPECT_EQ(burley.find(none), std::string::npos) << burley;
}

TEST_F(Sources, OfTheReferenceAreIntegratedOverAnEnvironmentOrRefused)
{
    const std::string out = folder.file("r.exr");
    const auto run = [&](const std::string& preset) {
        return runTorrance(
            {"reference", "demo", "-r", "16x16", "--samples", "64", "-e", "furnace", "--preset", preset, "-o", out});
    };
    const Outcome phong = run("phong"); // its ambient part has no integral
    EXPECT_EQ(phong.exitCode, 2);
    EXPECT_TRUE(isOneLine(phong.errors)) << phong.errors;
    EXPECT_NE(phong.errors.find("--environment none"), std::string::npos) << phong.errors;
    EXPECT_TRUE(folder.names().empty());
    for (const char* preset : {"torrance-sparrow-blinn", "ggx-burley"}) {
        const Outcome outcome = run(preset);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
        EXPECT_TRUE(std::filesystem::remove(out)) << preset;
    }
}

TEST_F(Sources, RefuseLightsThatAreNone)
{
    refused({"--light", "cone:direction=0,1,0"}, "constant, directional and point");
    refused({"--light", "constant:distance=2"}, "direction is missing");
    refused({"--light", "constant:direction=0,1,0,distance=0"}, "distance");
    refused({"--light", "directional:direction=0,0,0"}, "no length");
    refused({"--light", "point:position=1,2"}, "takes 3");
    refused({"--light", "point:position=1,2,3,shine=2"}, "no shine");
    refused({"--light", "point:position=1,2,3,intensity=-1"}, "negative");
}

// A light of the command line has a radius as one of the file has, and is then sampled; a directional light has none.
TEST_F(Sources, GiveLightsOfTheCommandLineTheRadius)
{
    const auto directions = [&](const std::vector<std::string>& radius) {
        std::vector<std::string> arguments = {"reference", "--primitive", "sphere", "-r", "8x8", "--samples", "16"};
        for (const char* argument : {"--environment", "none", "--light", "point:position=0,0,3", "--json", "-", "-o"})
            arguments.push_back(argument);
        arguments.push_back(folder.file("lit.exr"));
        arguments.insert(arguments.end(), radius.begin(), radius.end());
        const Outcome outcome = runTorrance(arguments);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
        return nlohmann::json::parse(outcome.output)["pictures"][0]["directions"].get<double>();
    };
    EXPECT_EQ(directions({}), 0.0);
    EXPECT_GT(directions({"--light-radius", "0.5"}), 0.0);
}

TEST_F(Sources, RefuseARadiusWithoutALightThatHasOne)
{
    refused({"--light", "directional:direction=0,0,1", "--light-radius", "0.5"}, "point and spot");
}

TEST_F(Sources, RefuseViewsOfWhatIsNotThere)
{
    refused({"--view", "D"}, "--light");
    refused({"--view", "F", "--preset", "phong"}, "phong is not");
    refused({"--view", "irradiance", "--environment", "none"}, "--environment");
    refused({"--view", "albedo", "--view-light", "0"}, "--view-light");
    refused({"--view", "dfg", "--preset", "smith-r"}, "directional albedos");
    refused({"--view", "albedo", "--tone", "agx"}, "--tone");
    refused({"--view", "albedo", "--path", "deferred"}, "deferred");
}

TEST_F(Sources, SayTheScaleOfAView)
{
    const Outcome outcome =
        runTorrance({"render", "demo", "-r", "16x16", "--light", "constant:direction=1,1,1,distance=2,intensity=30",
                     "--view", "half_vector", "-o", folder.file("h.png"), "--json", folder.file("h.json")});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    EXPECT_NE(outcome.output.find("0.5 * half_vector + 0.5"), std::string::npos) << outcome.output;
    std::ifstream file(folder.file("h.json"));
    const auto view = nlohmann::json::parse(file)["pictures"][0]["view"];
    EXPECT_EQ(view, (nlohmann::json{{"term", "half_vector"}, {"factor", 0.5}, {"offset", 0.5}, {"light", 0}}));
}

} // namespace
} // namespace torrance::test
