// `torrance reference` as a user meets it. What it computes is tested in tests/unit/reference.
#include "program.h"

#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>

namespace torrance::test {
namespace {

class Reference : public ::testing::Test
{
protected:
    std::string contentOf(const std::string& name)
    {
        std::ifstream file(folder.file(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

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
    EXPECT_NE(contentOf("a.exr"), "");
    for (const char* threads : {"1", "3"}) {
        run({"reference", "demo", "-r", "48x32", "--samples", "64", "-o", folder.file("b.exr")},
            {std::string("TORRANCE_THREADS=") + threads});
        EXPECT_EQ(contentOf("a.exr"), contentOf("b.exr")) << threads;
    }
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

TEST_F(Reference, RefusesOptionsThatContradictEachOther)
{
    const std::string out = folder.file("a.png");
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--samples", "0"},
                                                  {"--target-error", "0"},
                                                  {"--target-error", "nan"},
                                                  {"--max-samples", "128"},
                                                  {"--target-error", "0.1", "--samples", "512", "--max-samples", "256"},
                                                  {"--directions", "lights"},
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
