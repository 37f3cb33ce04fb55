// `torrance chart` and `torrance calibrate` as a script meets them. What methods cost is nobody's to assert here.
#include "program.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

namespace torrance::test {
namespace {

using nlohmann::json;

const std::string kShipped = TORRANCE_SOURCE_DIR "/assets/methods.measured.json";

// Two slots, the second of which takes about a second.
const std::vector<std::string> kTwoSlots = {"chart", "--slot", "tone,model", "--seconds", "0.05"};

std::vector<std::string> into(const std::string& folder, std::vector<std::string> more = {})
{
    std::vector<std::string> arguments = kTwoSlots;
    arguments.insert(arguments.end(), {"-o", folder});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

// Of every method what does not depend on the machine's load.
json errorsOf(const std::string& folder)
{
    json errors;
    for (const json& method : json::parse(contentOf(folder + "/methods.measured.json"))["methods"])
        errors.push_back({method["slot"], method["id"], method["truth"], method.value("error", json())});
    return errors;
}

TEST(Chart, WritesPageDrawingTableAndNumbers)
{
    const TestFolder folder;
    const Outcome outcome = runTorrance(into(folder.file("out")));
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    EXPECT_FALSE(std::filesystem::exists(folder.file("out/methods.part")));
    const json table = json::parse(contentOf(folder.file("out/methods.measured.json")));
    EXPECT_EQ(table["schema"], "torrance-methods/1");
    ASSERT_EQ(table["methods"].size(), 6u + 8u) << "of tone and model, as the registry has them";
    for (const json& method : table["methods"])
        EXPECT_GT(method["cost"]["ns_per_pixel"]["median"], 0.0) << method["id"];
    EXPECT_TRUE(contentOf(folder.file("out/methods.csv")).starts_with("slot,method,truth,"));
    EXPECT_TRUE(contentOf(folder.file("out/methods.svg")).starts_with("<svg "));
    // A model against itself in double is as far off as rounding, and the sphere set is where it should be.
    for (const json& method : table["methods"])
        if (method["slot"] == "model") {
            EXPECT_LT(method["error"]["mean"], 1e-4) << method["id"];
        }
}

TEST(Chart, GoesOnWhereItWasInterrupted)
{
    const TestFolder folder;
    ASSERT_EQ(runTorrance(into(folder.file("whole"))).exitCode, 0);
    const std::string part = folder.file("half/methods.part");
    const Outcome cut = runTorrance(into(folder.file("half")), {}, "", [&](int process) {
        for (int i = 0; i < 600 && contentOf(part).find("\"khronos_neutral\"") == std::string::npos; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        kill(process, SIGINT);
    });
    ASSERT_EQ(cut.exitCode, 128 + SIGINT) << cut.errors;
    EXPECT_TRUE(isOneLine(cut.errors)) << cut.errors;
    const json kept = json::parse(contentOf(part));
    ASSERT_EQ(kept["rows"].size(), 6u) << "the slot that was finished";
    EXPECT_EQ(runTorrance(into(folder.file("half"), {"--resume", "--environment-intensity", "2"})).exitCode, 3)
        << "other inputs";
    const Outcome resumed = runTorrance(into(folder.file("half"), {"--resume"}));
    ASSERT_EQ(resumed.exitCode, 0) << resumed.errors;
    EXPECT_EQ(errorsOf(folder.file("half")), errorsOf(folder.file("whole")));
    const json table = json::parse(contentOf(folder.file("half/methods.measured.json")));
    for (std::size_t i = 0; i < kept["rows"].size(); ++i)
        EXPECT_EQ(table["methods"][i], kept["rows"][i]["row"]) << "measured once";
}

// The plans of tolerances are found and charted once, and are as near as they say.
TEST(Chart, ChartsWhatTolerancesChoose)
{
    const TestFolder folder;
    const Outcome outcome =
        runTorrance({"chart", "--primitive", "sphere", "--roughness", "0.5", "-e", "sky", "-r", "24x24", "--seconds",
                     "0", "--tolerance", "draft,0.02", "-o", folder.file("out")});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    const json plans = json::parse(contentOf(folder.file("out/plans.json")));
    std::map<std::string, double> chosen;
    for (const json& plan : plans["plans"])
        if (plan["kind"] == "tolerance")
            chosen[plan["name"]] = plan["shading"];
    ASSERT_EQ(chosen.size(), 2u);
    EXPECT_LT(chosen.at("tolerance 5 %"), 0.05);
    EXPECT_LT(chosen.at("tolerance 2 %"), 0.02);
    for (const json& plan : plans["plans"])
        EXPECT_GT(plan["shading"], 0.0) << plan["name"];
    const std::string page = contentOf(folder.file("out/plans.svg"));
    EXPECT_NE(page.find("stroke-dasharray"), std::string::npos) << "lines of tolerances";
}

TEST(Chart, ChartsATableOfThisDeviceOnly)
{
    const TestFolder folder;
    json table = json::parse(contentOf(kShipped));
    table["driver"] = "another 1.0";
    std::ofstream(folder.file("other.json")) << table;
    const Outcome other = runTorrance({"chart", "-o", folder.file("out"), "--methods", folder.file("other.json")});
    EXPECT_EQ(other.exitCode, 3);
    EXPECT_TRUE(isOneLine(other.errors)) << other.errors;
    EXPECT_NE(other.errors.find("another 1.0"), std::string::npos) << other.errors;
    EXPECT_NE(other.errors.find("torrance calibrate"), std::string::npos) << other.errors;
}

TEST(Chart, RefusesWhatHasNoEffect)
{
    const TestFolder folder;
    const std::string out = folder.file("out");
    const Outcome unknown = runTorrance({"chart", "-o", out, "--slot", "fresnell"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.errors.find("did you mean fresnel?"), std::string::npos) << unknown.errors;
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"chart"},
                                               {"chart", "-o", out, "demo", "demo"},
                                               {"chart", "-o", out, "demo", "--slot", "tone"},
                                               {"chart", "-o", out, "demo", "--methods", kShipped},
                                               {"chart", "-o", out, "-r", "64x64"},
                                               {"chart", "-o", out, "--seconds", "-1"},
                                               {"chart", "-o", out, "-e", "none"},
                                               {"chart", "-o", out, "demo", "--tolerance", "0"},
                                               {"chart", "-o", out, "demo", "--tolerance", "draft,,1%"},
                                               {"chart", "-o", out, "--tolerance", "draft"},
                                               {"calibrate"}})
    {
        const Outcome outcome = runTorrance(arguments);
        EXPECT_EQ(outcome.exitCode, 2) << arguments.back() << outcome.errors;
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    }
    EXPECT_EQ(runTorrance({"chart", "-o", out, "absent.glb"}).exitCode, 3);
    EXPECT_EQ(runTorrance({"chart", "-o", out, "--methods", "absent.json"}).exitCode, 3);
    std::ofstream(folder.file("file")) << "x";
    const Outcome blocked = runTorrance({"chart", "-o", folder.file("file"), "--slot", "tone"});
    EXPECT_EQ(blocked.exitCode, 6);
    EXPECT_TRUE(isOneLine(blocked.errors)) << blocked.errors;
    EXPECT_EQ(runTorrance({"calibrate", "-o", folder.file("no/such/table.json")}).exitCode, 6);
}

} // namespace
} // namespace torrance::test
