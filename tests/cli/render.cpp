// `torrance render` as a user meets it: where pictures go, in which formats, and that the order of options is no
// matter. What is drawn is tested elsewhere.
#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace torrance::test {
namespace {

class Render : public ::testing::Test
{
protected:
    Outcome run(std::vector<std::string> arguments)
    {
        Outcome outcome = runTorrance(arguments);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
        return outcome;
    }

    TestFolder folder;
};

TEST_F(Render, WritesPngToStandardOutputAndNothingElse)
{
    run({"render", "demo", "-r", "32x24", "-o", folder.file("a.png")});
    const Outcome outcome = run({"render", "demo", "-r", "32x24", "-o", "-"});
    EXPECT_EQ(outcome.output, folder.content("a.png")) << "the same bytes as in a file";
    EXPECT_EQ(outcome.output.rfind("\x89PNG", 0), 0u);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.png"}));
}

TEST_F(Render, WritesEveryFormat)
{
    for (const auto& [name, start] : {std::pair(std::string("a.png"), std::string("\x89PNG")),
                                      {"a.jpg", "\xff\xd8\xff"},
                                      {"a.webp", "RIFF"},
                                      {"a.exr", "\x76\x2f\x31\x01"},
                                      {"a.hdr", "#?RADIANCE"}})
    {
        run({"render", "demo", "-r", "16,12", "-o", folder.file(name)});
        EXPECT_EQ(folder.content(name).rfind(start, 0), 0u) << name;
        run({"compare", folder.file(name), folder.file(name)}); // can be read, and has no NaN
    }
}

TEST_F(Render, OptionsMayStandAnywhere)
{
    run({"render", "demo", "-r", "32x24", "--exposure", "-1", "-o", folder.file("a.png")});
    run({"-o", folder.file("b.png"), "--exposure=-1", "render", "--resolution", "32,24", "demo"});
    EXPECT_EQ(folder.content("a.png"), folder.content("b.png"));
}

TEST_F(Render, DrawsSeveralInputsInOneRun)
{
    const std::string source = TORRANCE_BINARY_DIR "/share/torrance/assets/demo";
    std::filesystem::copy(source, folder.path / "first");
    std::filesystem::copy(source, folder.path / "second");
    std::filesystem::rename(folder.path / "second/demo.gltf", folder.path / "second/other.gltf");
    const Outcome outcome = run({"render", folder.file("first/demo.gltf"), folder.file("second/other.gltf"), "-r",
                                 "32x24", "-o", folder.file("{stem}.png"), "--json", "-"});
    EXPECT_EQ(folder.content("demo.png"), folder.content("other.png"));
    EXPECT_NE(folder.content("demo.png"), "");
    EXPECT_EQ(nlohmann::json::parse(outcome.output)["pictures"].size(), 2u);
}

TEST_F(Render, GivesTheSameBytesWhateverTheThreadsAndTheCache)
{
    run({"render", "demo", "-r", "48x32", "-o", folder.file("a.png")});
    run({"render", "demo", "-r", "48x32", "-o", folder.file("b.png"), "--no-cache"});
    EXPECT_EQ(folder.content("a.png"), folder.content("b.png"));
    for (const char* threads : {"0", "1", "4"}) {
        const Outcome outcome = runTorrance({"render", "demo", "-r", "48x32", "-o", folder.file("c.png")},
                                            {std::string("LP_NUM_THREADS=") + threads, "TORRANCE_THREADS=1"});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
        EXPECT_EQ(folder.content("a.png"), folder.content("c.png")) << "LP_NUM_THREADS=" << threads;
    }
}

TEST_F(Render, ExplainsToStandardOutputAndTimesToStandardError)
{
    const Outcome outcome =
        run({"render", "demo", "-r", "16x12", "-o", folder.file("a.png"), "--explain", "--verbose"});
    EXPECT_NE(outcome.output, "");
    EXPECT_NE(outcome.errors.find(" ms"), std::string::npos) << outcome.errors;
    const Outcome quiet = run({"render", "demo", "-r", "16x12", "-o", folder.file("a.png"), "--quiet"});
    EXPECT_EQ(quiet.output + quiet.errors, "");
}

} // namespace
} // namespace torrance::test
