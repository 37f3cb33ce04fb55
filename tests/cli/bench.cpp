// `torrance bench` as a script meets it. What a frame costs is nobody's to assert here: times are only asked to be
// there, and verdicts are those on files whose times were changed.
#include "program.h"

#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace torrance::test {
namespace {

using nlohmann::json;

const std::vector<std::string> kCube = {"bench", "--primitive", "cube", "-r", "16x12", "--frames", "12"};

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more)
{
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

json jsonOf(const std::vector<std::string>& arguments)
{
    const Outcome outcome = runTorrance(with(arguments, {"--json", "-"}));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    return json::parse(outcome.output);
}

void write(const std::string& file, const json& content)
{
    std::ofstream(file) << content;
}

std::size_t linesOf(const std::string& file)
{
    std::ifstream stream(file);
    std::size_t count = 0;
    for (std::string line; std::getline(stream, line);)
        ++count;
    return count;
}

TEST(Bench, SaysWhatAFrameCostsAndWhatItIsMadeOf)
{
    const TestFolder folder;
    const json record = jsonOf(with(kCube, {"--path", "forward", "--csv", folder.file("frames.csv")}));
    EXPECT_EQ(record["schema"], "torrance-bench/1");
    for (const char* text : {"program", "date", "processor", "system", "device", "driver", "clock"})
        EXPECT_FALSE(record[text].get<std::string>().empty()) << text;
    ASSERT_EQ(record["results"].size(), 1u);
    const json& cube = record["results"][0];
    EXPECT_EQ(cube["name"], "cube");
    EXPECT_EQ(cube["width"], 16);
    EXPECT_EQ(cube["height"], 12);
    EXPECT_EQ(cube["triangles"], 12);
    EXPECT_EQ(cube["draws"], 1);
    EXPECT_EQ(cube["path"], "forward");
    for (const char* clock : {"cpu_ms", "wall_ms"}) {
        EXPECT_EQ(cube[clock]["count"], 12);
        EXPECT_GT(cube[clock]["low"], 0.0);
        EXPECT_GE(cube[clock]["median"], cube[clock]["low"]);
        EXPECT_GE(cube[clock]["high"], cube[clock]["median"]);
    }
    std::vector<std::string> phases;
    for (const auto& [name, use] : cube["start_up"].items())
        phases.push_back(name);
    const std::vector<std::string> expected = {"display transform", "encode",      "first draw", "load", "plan",
                                               "read back",         "second draw", "upload"};
    EXPECT_EQ(phases, expected) << "by name, as this library sorts them";
    EXPECT_GT(cube["passes"]["surfaces"]["cpu_ms"]["median"], 0.0);
    EXPECT_GT(record["peak_pss_mib"], 0.0);
    EXPECT_GT(record["peak_rss_mib"], 0.0);
    EXPECT_EQ(linesOf(folder.file("frames.csv")), 13u) << "a line of names and one for each frame";
}

TEST(Bench, MeasuresSettingsSideBySide)
{
    const json record = jsonOf(with(kCube, {"--vary", "path=forward,deferred", "--vary", "samples=1,2"}));
    std::vector<std::string> names;
    for (const json& result : record["results"])
        names.push_back(result["name"]);
    const std::vector<std::string> expected = {"cube path=forward samples=1", "cube path=forward samples=2",
                                               "cube path=deferred samples=1", "cube path=deferred samples=2"};
    EXPECT_EQ(names, expected);
    EXPECT_FALSE(record["results"][0].contains("ratio"));
    EXPECT_EQ(record["results"][3]["ratio"]["count"], 12);
    EXPECT_EQ(record["results"][3]["samples"], 2);
    EXPECT_EQ(record["results"][3]["path"], "deferred");
    EXPECT_TRUE(record["results"][3]["passes"].contains("G-buffer"));
}

TEST(Bench, JudgesAgainstAnEarlierFile)
{
    const TestFolder folder;
    const std::string file = folder.file("then.json");
    json then = jsonOf(kCube);
    const auto scaleTimes = [&](double factor) {
        json scaled = then;
        for (const char* clock : {"cpu_ms", "wall_ms"})
            for (const char* member : {"median", "low", "high"})
                scaled["results"][0][clock][member] = factor * then["results"][0][clock][member].get<double>();
        write(file, scaled);
    };
    scaleTimes(1e-3);
    const Outcome slower = runTorrance(with(kCube, {"--against", file}));
    EXPECT_EQ(slower.exitCode, 1) << slower.output << slower.errors;
    EXPECT_NE(slower.output.find("SLOWER"), std::string::npos) << slower.output;
    scaleTimes(1e3);
    const Outcome faster = runTorrance(with(kCube, {"--against", file}));
    EXPECT_EQ(faster.exitCode, 0) << faster.output << faster.errors;
    EXPECT_NE(faster.output.find(": faster"), std::string::npos) << faster.output;
}

TEST(Bench, RefusesFilesThatItCannotCompareWith)
{
    const TestFolder folder;
    const std::string file = folder.file("then.json");
    const auto refused = [&](const std::string& name, const std::string& why) {
        const Outcome outcome = runTorrance(with(kCube, {"--against", name}));
        EXPECT_EQ(outcome.exitCode, 3) << outcome.errors;
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
        EXPECT_NE(outcome.errors.find(why), std::string::npos) << outcome.errors;
    };
    refused(folder.file("absent.json"), "absent.json");
    std::ofstream(file) << "{ not JSON";
    refused(file, "then.json");
    write(file, json{{"schema", "torrance-bench/0"}});
    refused(file, "torrance-bench/0");
    json then = jsonOf(kCube);
    then["device"] = "another";
    write(file, then);
    refused(file, "another");
    then = jsonOf({"bench", "--primitive", "cube", "-r", "12x12", "--frames", "1"});
    write(file, then);
    refused(file, "12x12, and 16x12 now");
}

TEST(Bench, MeasuresGrowth)
{
    const TestFolder folder;
    const Outcome outcome = runTorrance({"bench", "--growth", "instances", "-r", "16x16", "--frames", "1", "--json",
                                         "-", "--csv", folder.file("growth.csv")});
    EXPECT_EQ(outcome.exitCode, 0) << "one round decides nothing: " << outcome.errors;
    const json record = json::parse(outcome.output);
    EXPECT_EQ(record["schema"], "torrance-bench-growth/1");
    ASSERT_EQ(record["series"].size(), 1u);
    const json& series = record["series"][0];
    EXPECT_EQ(series["sizes"], (json{10.0, 100.0, 1000.0, 10000.0, 100000.0}));
    EXPECT_EQ(series["draws"], (json{1, 1, 1, 1, 1})) << "10 000 instances are one draw";
    EXPECT_EQ(series["frame"]["growth"], "undecided");
    EXPECT_EQ(series["frame"]["ms"].size(), 5u);
    EXPECT_GT(series["memory"]["mib"][4]["median"], 0.0);
    EXPECT_EQ(linesOf(folder.file("growth.csv")), 6u);
}

TEST(Bench, RefusesWhatHasNoEffect)
{
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"bench"},
                                               {"bench", "demo", "--vary", "background"},
                                               {"bench", "demo", "--vary", "--lens=wide"},
                                               {"bench", "demo", "--vary", "path=backward"},
                                               {"bench", "demo", "--limit", "2"},
                                               {"bench", "--growth", "lihgts"},
                                               {"bench", "demo", "--growth", "lights"},
                                               {"bench", "demo", "--soak", "50"},
                                               {"bench", "demo", "--soak", "200", "--growth", "all"},
                                               {"bench", "demo", "--soak", "200", "--against", "a.json"},
                                               {"bench", "demo", "--frames", "0"}})
    {
        const Outcome outcome = runTorrance(arguments);
        EXPECT_EQ(outcome.exitCode, 2) << arguments.back();
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    }
}

} // namespace
} // namespace torrance::test
