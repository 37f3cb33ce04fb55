// `torrance view` as a process; tests/view drives the window itself.
#include "program.h"

#include <filesystem>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

TEST(Window, WhatDrawsPicturesLinksNoWindowSystem)
{
    // The dynamic loader lists what it would load, and ends.
    const std::string libraries = runTorrance({"render"}, {"LD_TRACE_LOADED_OBJECTS=1"}).output;
    ASSERT_NE(libraries.find("libc.so"), std::string::npos) << libraries;
    for (const char* name : {"libglfw", "libX", "libxcb", "libwayland", "libGL", "imgui"})
        EXPECT_EQ(libraries.find(name), std::string::npos) << name << " in\n" << libraries;
}

// Where GLFW or Dear ImGui is missing there is no window, and one line says so.
const bool kBuilt = std::filesystem::exists(TORRANCE_BINARY_DIR "/bin/torrance-view");

TEST(Window, SaysWhatIsWrongBeforeItOpens)
{
    if (!kBuilt)
        GTEST_SKIP() << "there is no window in this build";
    const std::vector<std::vector<std::string>> wrong = {{"view", "demo", "other.glb"},
                                                         {"view", "demo", "-e", "no_such_file.hdr"},
                                                         {"view", "demo", "--environment-rotation", "nan"},
                                                         {"view", "demo", "--distribution", "none_such"},
                                                         {"view", "demo", "--resolution", "0x100"},
                                                         {"view", "demo", "--no-such-option"}};
    for (const std::vector<std::string>& arguments : wrong) {
        const Outcome outcome = runTorrance(arguments, {"DISPLAY="});
        EXPECT_TRUE(outcome.exitCode == 2 || outcome.exitCode == 3) << outcome.exitCode << outcome.errors;
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    }
}

TEST(Window, WithoutADisplayNamesWhatDrawsWithoutOne)
{
    const Outcome outcome = runTorrance({"view", "demo"}, {"DISPLAY="});
    EXPECT_EQ(outcome.exitCode, 4) << outcome.errors;
    EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    EXPECT_NE(outcome.errors.find("torrance render"), std::string::npos) << outcome.errors;
}

} // namespace
} // namespace torrance::test
