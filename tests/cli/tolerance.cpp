// `torrance render --tolerance` as a user meets it.
#include "program.h"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace torrance::test {
namespace {

class Tolerance : public ::testing::Test
{
protected:
    std::vector<std::string> arguments(std::vector<std::string> more)
    {
        std::vector<std::string> all = {"render", "-r", "40x40", "-o", folder.file("a.exr")};
        if (std::ranges::find(more, "--certify=400") == more.end())
            all.emplace_back("--certify=64");
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    nlohmann::json certificate() { return nlohmann::json::parse(folder.content("a.exr.certificate.json")); }
    void expectRefused(std::vector<std::string> more, int code, const std::string& why)
    {
        const Outcome outcome = runTorrance(arguments(std::move(more)));
        EXPECT_EQ(outcome.exitCode, code) << outcome.errors;
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
        EXPECT_NE(outcome.errors.find(why), std::string::npos) << outcome.errors;
        EXPECT_EQ(folder.names(), (std::vector<std::string>{}));
    }

    TestFolder folder;
};

const std::vector<std::string> kMetal = {"--primitive", "sphere", "--roughness", "0.5", "--metallic", "1"};

std::vector<std::string> operator+(std::vector<std::string> a, const std::vector<std::string>& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

TEST_F(Tolerance, IsKeptAndCertified)
{
    double before = 1.0;
    for (const auto& [name, share] : {std::pair("10%", 0.1), std::pair("4%", 0.04)}) {
        const Outcome outcome =
            runTorrance(arguments(kMetal + std::vector<std::string>{std::string("--tolerance=") + name, "--explain"}));
        ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
        const auto json = certificate();
        EXPECT_EQ(json["tolerance"]["mean"], share);
        EXPECT_EQ(json["tolerance"]["holds"], true);
        EXPECT_LE(json["shading"]["mean"]["high"].get<double>(), share);
        const double error = json["shading"]["mean"]["value"];
        EXPECT_LE(error, before);
        before = error;
        EXPECT_LE(json["tolerance"]["trials"].size(), 5u);
        EXPECT_NE(outcome.output.find("tolerance, environment_specular"), std::string::npos) << outcome.output;
        EXPECT_NE(outcome.output.find("not even (outside its domain"), std::string::npos);
        EXPECT_EQ(runTorrance({"verify", folder.file("a.exr")}).exitCode, 0);
    }
}

// The certificate's record is the same picture by its methods' names: nothing is searched when it is verified.
TEST_F(Tolerance, RecordsTheMethodsThatWereFound)
{
    ASSERT_EQ(runTorrance(arguments(kMetal + std::vector<std::string>{"--tolerance=2%"})).exitCode, 0);
    const auto json = certificate();
    std::vector<std::string> again = {"render", "-o", folder.file("b.exr"), "--certify"};
    for (const auto& argument : json["scene"]["arguments"])
        again.push_back(argument);
    for (const std::string& argument : again)
        EXPECT_EQ(argument.find("--tolerance"), std::string::npos);
    ASSERT_EQ(runTorrance(again).exitCode, 0);
    const auto found = nlohmann::json::parse(folder.content("b.exr.certificate.json"));
    EXPECT_EQ(found["image"]["hash"], json["image"]["hash"]); // of the pixels
}

TEST_F(Tolerance, WhatNeedsNothingGetsNothing)
{
    const Outcome outcome = runTorrance(arguments({"--primitive", "sphere", "--roughness", "0.6", "--metallic", "0",
                                                   "-e", "furnace", "--tolerance", "draft", "--explain"}));
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    EXPECT_NE(outcome.output.find("environment_diffuse: even"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("environment_specular: even"), std::string::npos);
    EXPECT_NE(outcome.output.find("directional albedo table: left out"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("no multiple scattering"), std::string::npos);
    EXPECT_EQ(certificate()["tolerance"]["trials"].size(), 1u);
}

TEST_F(Tolerance, LeavesMethodsAloneThatWereAskedForByName)
{
    ASSERT_EQ(runTorrance(arguments(kMetal + std::vector<std::string>{"--tolerance=1", "--environment-diffuse", "sh9"}))
                  .exitCode,
              0);
    EXPECT_EQ(certificate()["plan"]["methods"]["environment_diffuse"], "sh9");
}

TEST_F(Tolerance, SaysWhatStandsInTheWay)
{
    const Outcome outcome = runTorrance(
        arguments(kMetal + std::vector<std::string>{"--tolerance=2%", "--environment-specular", "split_sum"}));
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.errors.find("not within the tolerance: the mean error is"), std::string::npos) << outcome.errors;
    EXPECT_NE(outcome.errors.find("environment_specular split_sum"), std::string::npos) << outcome.errors;
    EXPECT_EQ(certificate()["tolerance"]["holds"], false);
    EXPECT_EQ(runTorrance({"verify", folder.file("a.exr")}).exitCode, 0) << "what it says is true";
}

// The mean alone is content with a cheaper method. No 64 pixels bound a 99th percentile: more are looked at.
TEST_F(Tolerance, OfThe99thPercentileIsKept)
{
    ASSERT_EQ(runTorrance(arguments(kMetal + std::vector<std::string>{"--tolerance=10%", "--certify=400"})).exitCode,
              0);
    const auto ofMean = certificate();
    const double bound = 0.7 * ofMean["shading"]["percentile_99"]["value"].get<double>();
    const Outcome outcome = runTorrance(
        arguments(kMetal + std::vector<std::string>{"--tolerance=10%", "--tolerance-p99=" + std::to_string(bound)}));
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    const auto ofBoth = certificate();
    EXPECT_LE(ofBoth["shading"]["percentile_99"]["high"].get<double>(), bound);
    EXPECT_NE(ofBoth["tolerance"]["trials"].back()["methods"], ofMean["tolerance"]["trials"].back()["methods"]);
    EXPECT_GT(ofBoth["sample"]["asked"].get<int>(), 368);
    EXPECT_EQ(runTorrance({"verify", folder.file("a.exr")}).exitCode, 0);
}

TEST_F(Tolerance, BadOnesAreRefused)
{
    for (const char* bad : {"0", "-1%", "nan", "1.5", "101%", "coarse", "1%%"})
        expectRefused(kMetal + std::vector<std::string>{std::string("--tolerance=") + bad}, 2, "--tolerance");
    expectRefused(kMetal + std::vector<std::string>{"--tolerance=1%", "--tolerance-p99=0"}, 2, "--tolerance-p99");
    expectRefused(kMetal + std::vector<std::string>{"--tolerance-p99=1%"}, 2, "add --tolerance");
    expectRefused(kMetal + std::vector<std::string>{"--methods=a.json"}, 2, "add --tolerance");
    expectRefused(kMetal + std::vector<std::string>{"--tolerance=1%", "--view", "normal"}, 2, "--view");
}

TEST_F(Tolerance, ACalibrationOfAnotherDeviceIsRefused)
{
    std::ifstream shipped(std::string(TORRANCE_SOURCE_DIR) + "/assets/methods.measured.json");
    auto table = nlohmann::json::parse(shipped);
    table["device"] = "Another Device";
    const TestFolder elsewhere;
    std::ofstream(elsewhere.file("table.json")) << table.dump();
    expectRefused(kMetal + std::vector<std::string>{"--tolerance=1%", "--methods=" + elsewhere.file("table.json")}, 3,
                  "Another Device");
    std::ofstream(elsewhere.file("table.json")) << "{";
    expectRefused(kMetal + std::vector<std::string>{"--tolerance=1%", "--methods=" + elsewhere.file("table.json")}, 3,
                  "table.json");
}

TEST_F(Tolerance, NothingCoveredIsSaid)
{
    expectRefused({"--primitive", "sphere", "--tolerance=1%", "--camera-position", "0,0,5", "--camera-target", "0,0,9"},
                  2, "no surface is seen");
}

} // namespace
} // namespace torrance::test
