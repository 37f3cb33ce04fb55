// `torrance reference` as a user meets it. What it computes is tested in tests/unit/reference.
#include "program.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <thread>

namespace torrance::test {
namespace {

class Reference : public ::testing::Test
{
protected:
    Outcome run(std::vector<std::string> arguments, const std::vector<std::string>& environment = {})
    {
        Outcome outcome = runTorrance(arguments, environment);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
        return outcome;
    }

    TestFolder folder;
};

TEST_F(Reference, GivesTheSameBytesWhateverTheThreads)
{
    run({"reference", "demo", "-r", "48x32", "--samples", "64", "-o", folder.file("a.exr")});
    EXPECT_NE(folder.content("a.exr"), "");
    for (const char* threads : {"1", "3"}) {
        run({"reference", "demo", "-r", "48x32", "--samples", "64", "-o", folder.file("b.exr")},
            {std::string("TORRANCE_THREADS=") + threads});
        EXPECT_EQ(folder.content("a.exr"), folder.content("b.exr")) << threads;
    }
}

TEST_F(Reference, TransportGivesTheSameBytesWhateverTheThreadsAndAfterAnInterruption)
{
    const auto words = [&](const std::string& name, std::vector<std::string> more) {
        std::vector<std::string> all = {"reference", "demo",         "--transport", "-r", "24x16",          "--samples",
                                        "64",        "--checkpoint", "0",           "-o", folder.file(name)};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    run(words("a.exr", {}), {"TORRANCE_THREADS=1"});
    run(words("b.exr", {}), {"TORRANCE_THREADS=3"});
    EXPECT_EQ(folder.content("a.exr"), folder.content("b.exr"));
    const std::string part = folder.file("c.exr.part");
    const Outcome killed = runTorrance(words("c.exr", {}), {}, "", [&](int process) {
        while (!std::filesystem::exists(part) && kill(process, 0) == 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        kill(process, SIGKILL);
    });
    ASSERT_EQ(killed.exitCode, 128 + SIGKILL) << "it ended too soon: " << killed.errors;
    const std::vector<std::string> other = {"reference",          "demo",    "-r", "24x16", "--samples", "64", "-o",
                                            folder.file("c.exr"), "--resume"};
    EXPECT_NE(runTorrance(other).errors.find("other options"), std::string::npos) << "without transport it is another";
    run(words("c.exr", {"--resume"}));
    EXPECT_EQ(folder.content("a.exr"), folder.content("c.exr"));
    run({"reference", "demo", "-r", "24x16", "--samples", "64", "-o", folder.file("d.exr")});
    EXPECT_NE(folder.content("a.exr"), folder.content("d.exr"));
}

TEST_F(Reference, WritesLayersIntoAnExrAndBesideOtherFiles)
{
    run({"reference", "demo", "-r", "8x6", "--samples", "64", "-o", folder.file("a.png"), "--aov", "depth,variance"});
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.depth.exr", "a.png", "a.variance.exr"}));
    run({"reference", "demo", "-r", "8x6", "--samples", "64", "-o", folder.file("b.exr"), "--aov", "all"});
    const std::string exr = folder.content("b.exr");
    for (const char* channel : {"variance.G", "directions.V", "depth.V", "normal.X", "base_color.R", "object_id.V"})
        EXPECT_NE(exr.find(channel), std::string::npos) << channel;
}

TEST_F(Reference, TargetErrorIsMetWhereTheDirectionsSuffice)
{
    const auto widthOf = [&](std::vector<std::string> sampling) {
        std::vector<std::string> arguments = {"reference",          "demo",   "-r", "24x16", "-o",
                                              folder.file("a.exr"), "--json", "-"};
        arguments.insert(arguments.end(), sampling.begin(), sampling.end());
        return nlohmann::json::parse(run(arguments).output)["pictures"][0]["mean_half_width_95"].get<double>();
    };
    EXPECT_GT(widthOf({"--samples", "64"}), 0.05);
    // Each pixel's width is below 0.05 (|c| + 1 % of the mean |c|): summed over pixels, below 1.01 * 0.05 of the sum.
    EXPECT_LT(widthOf({"--samples", "64", "--target-error", "0.05", "--max-samples", "1000000"}), 1.01 * 0.05);
}

// Long enough that a signal arrives before the end.
const std::vector<std::string> kLongWork = {"reference", "demo", "-r",           "48x32",
                                            "--samples", "512",  "--checkpoint", "0"};

TEST_F(Reference, AnInterruptedRunGoesOnToTheSameBits)
{
    const auto arguments = [&](const std::string& name, bool resume) {
        std::vector<std::string> words = kLongWork;
        words.insert(words.end(), {"-o", folder.file(name)});
        if (resume)
            words.emplace_back("--resume");
        return words;
    };
    run(arguments("whole.exr", true)); // without a file to go on with it begins
    for (const int signal : {SIGKILL, SIGTERM, SIGINT}) {
        const std::string part = folder.file("part.exr.part");
        const Outcome killed = runTorrance(arguments("part.exr", false), {}, "", [&](int process) {
            while (!std::filesystem::exists(part) && kill(process, 0) == 0)
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            kill(process, signal);
        });
        ASSERT_EQ(killed.exitCode, 128 + signal) << "it ended too soon, or otherwise: " << killed.errors;
        ASSERT_TRUE(std::filesystem::exists(part));
        EXPECT_FALSE(std::filesystem::exists(folder.file("part.exr")));
        EXPECT_EQ(signal != SIGKILL, killed.errors.find("--resume") != std::string::npos) << killed.errors;
        run(arguments("part.exr", true));
        EXPECT_EQ(folder.content("part.exr"), folder.content("whole.exr")) << signal;
        EXPECT_FALSE(std::filesystem::exists(part)) << "nothing to go on with is left";
        std::filesystem::remove(folder.file("part.exr"));
    }
}

TEST_F(Reference, RefusesACheckpointOfOtherInputsAndADamagedOne)
{
    const std::string out = folder.file("a.exr"), part = out + ".part";
    std::vector<std::string> words = kLongWork;
    words.insert(words.end(), {"-o", out});
    runTorrance(words, {}, "", [&](int process) {
        while (!std::filesystem::exists(part) && kill(process, 0) == 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        kill(process, SIGKILL);
    });
    words.emplace_back("--resume");
    const auto expectRefused = [&](std::vector<std::string> more, const std::string& why) {
        std::vector<std::string> all = words;
        all.insert(all.end(), more.begin(), more.end());
        const Outcome outcome = runTorrance(all);
        EXPECT_EQ(outcome.exitCode, 3) << why;
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
        EXPECT_NE(outcome.errors.find(why), std::string::npos) << outcome.errors;
        EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
        EXPECT_FALSE(std::filesystem::exists(out));
    };
    for (const std::vector<std::string>& other : {std::vector<std::string>{"--preset", "gltf"},
                                                  {"--orbit", "10,80"},
                                                  {"-e", "sky"},
                                                  {"--pixel-samples", "2"},
                                                  {"--environment-rotation", "1"},
                                                  {"--background", "transparent"}})
        expectRefused(other, "other options");
    const std::string good = folder.content("a.exr.part");
    std::ofstream(part, std::ios::binary) << good.substr(0, good.size() - 1);
    expectRefused({}, "damaged");
    std::ofstream(part, std::ios::binary) << good.substr(0, good.size() - 1) << 'x';
    expectRefused({}, "damaged");
    std::ofstream(part, std::ios::binary) << "short";
    expectRefused({}, "no checkpoint");
}

TEST_F(Reference, RefusesOptionsThatContradictEachOther)
{
    const std::string out = folder.file("a.png");
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--samples", "0"},
                                                  {"--target-error", "0"},
                                                  {"--target-error", "nan"},
                                                  {"--max-samples", "128"},
                                                  {"--target-error", "0.1", "--samples", "512", "--max-samples", "256"},
                                                  {"--directions", "lights"},
                                                  {"--aov", "varience"},
                                                  {"--yardstick", "physics", "--preset", "gltf"},
                                                  {"--transport", "--preset", "phong"},
                                                  {"--yardstick", "physics", "--diffuse", "burley"},
                                                  {"--fresnel", "exact_conductor"}})
    {
        std::vector<std::string> arguments = {"reference", "demo", "-o", out};
        arguments.insert(arguments.end(), wrong.begin(), wrong.end());
        const Outcome outcome = runTorrance(arguments);
        EXPECT_EQ(outcome.exitCode, 2) << wrong[0] << ": " << outcome.errors;
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    }
    EXPECT_TRUE(folder.names().empty());
}

} // namespace
} // namespace torrance::test
