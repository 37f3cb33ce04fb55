#include "program.h"

#include <fstream>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

// The program's data with one line of one shader changed.
void copyDataWithFault(const std::filesystem::path& to, const std::string& shader, const std::string& from,
                       const std::string& fault)
{
    std::filesystem::copy(TORRANCE_BINARY_DIR "/share/torrance", to,
                          std::filesystem::copy_options::recursive | std::filesystem::copy_options::skip_symlinks);
    std::filesystem::copy(TORRANCE_SOURCE_DIR "/shaders", to / "shaders", std::filesystem::copy_options::recursive);
    std::string text = contentOf((to / "shaders" / shader).string());
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << shader;
    std::ofstream(to / "shaders" / shader) << text.replace(at, from.size(), fault);
}

TEST(Conform, PassesOnThisDeviceWithoutAWordOfValidation)
{
    const TestFolder folder;
    const Outcome outcome = runTorrance({"conform", "--validation", "-o", folder.file("out")});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output << outcome.errors;
    for (const char* group : {"methods: pass", "brdf: pass", "furnace: pass", "shapes: pass", "presets: pass"})
        EXPECT_NE(outcome.output.find(group), std::string::npos) << group << " in " << outcome.output;
    EXPECT_NE(contentOf(folder.file("out/conform.xml")).find("failures=\"0\""), std::string::npos);
    EXPECT_NE(contentOf(folder.file("out/conform.html")).find("data:image/png;base64,"), std::string::npos);
}

// 1.0003: three times the tolerance of a picture, far above the rounding of a term.
TEST(Conform, FailsAndNamesTheCaseWhenAShaderIsWrong)
{
    const TestFolder folder;
    copyDataWithFault(folder.path / "data", "brdf/distribution/ggx.glsl", "return a2", "return 1.0003 * a2");
    const Outcome outcome = runTorrance({"conform", "--only", "methods", "--no-cache", "-o", folder.file("out")},
                                        {"TORRANCE_DATA=" + folder.file("data")});
    EXPECT_EQ(outcome.exitCode, 1) << outcome.output << outcome.errors;
    EXPECT_NE(outcome.output.find("methods: FAIL"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("FAIL D_ggx: "), std::string::npos) << outcome.output;
    EXPECT_EQ(outcome.output.find("FAIL D_beckmann"), std::string::npos) << outcome.output;
    const std::string xml = contentOf(folder.file("out/conform.xml"));
    EXPECT_NE(xml.find("name=\"D_ggx\">\n      <failure message="), std::string::npos) << xml;
    EXPECT_NE(contentOf(folder.file("out/conform.html")).find("FAIL"), std::string::npos);
}

TEST(Conform, GivesTheSameBytesWhateverTheThreads)
{
    const TestFolder folder;
    for (const char* threads : {"1", "3"})
        EXPECT_EQ(runTorrance({"conform", "--only", "furnace", "-o", folder.file(threads)},
                              {std::string("TORRANCE_THREADS=") + threads})
                      .exitCode,
                  0);
    for (const char* name : {"conform.xml", "conform.html"})
        EXPECT_EQ(contentOf(folder.file("1/") + name), contentOf(folder.file("3/") + name)) << name;
}

TEST(Conform, LeavesNothingBehindWithoutADevice)
{
    const TestFolder folder;
    const Outcome outcome = runTorrance({"conform", "--device", "no such device", "-o", folder.file("out")});
    EXPECT_EQ(outcome.exitCode, 4);
    EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    EXPECT_TRUE(folder.names().empty());
}

TEST(Conform, SaysAtOnceThatItsFolderCannotBeMade)
{
    const TestFolder folder;
    std::ofstream(folder.file("taken")) << "a file";
    const Outcome outcome = runTorrance({"conform", "-o", folder.file("taken")});
    EXPECT_EQ(outcome.exitCode, 6);
    EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    EXPECT_EQ(outcome.output, "");
    const Outcome unknown = runTorrance({"conform", "--only", "furnance"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.errors.find("furnace"), std::string::npos) << unknown.errors;
}

} // namespace
} // namespace torrance::test
