#include "view/recovery.h"

#include "core/error.h"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>

namespace torrance {
namespace {

TEST(Recovery, LiesInTheUsersStateFolder)
{
    setenv("XDG_STATE_HOME", "/state", 1);
    EXPECT_EQ(userStateFolder(), "/state/torrance");
    unsetenv("XDG_STATE_HOME");
    setenv("HOME", "/home/me", 1);
    EXPECT_EQ(userStateFolder(), "/home/me/.local/state/torrance");
    unsetenv("HOME");
    EXPECT_TRUE(userStateFolder().empty());
}

TEST(Recovery, ReplacesNothing)
{
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "torrance-recovery" / "deep";
    std::filesystem::remove_all(folder.parent_path());
    for (const char* name : {"lamp-unsaved.glb", "lamp-unsaved-2.glb", "lamp-unsaved-3.glb"}) {
        const std::filesystem::path file = recoveryFile(folder, "/models/lamp.gltf");
        EXPECT_EQ(file, folder / name);
        std::ofstream(file) << "taken";
    }
    EXPECT_EQ(recoveryFile(folder, "demo"), folder / "demo-unsaved.glb");
    std::filesystem::remove_all(folder.parent_path());
}

TEST(Recovery, SaysWhereItCannotBe)
{
    const auto saidOf = [](const std::filesystem::path& folder) {
        try {
            recoveryFile(folder, "a.glb");
            return std::string();
        } catch (const Error& error) {
            EXPECT_EQ(error.exitCode, ExitCode::cannotWrite);
            return std::string(error.what());
        }
    };
    EXPECT_NE(saidOf({}).find("XDG_STATE_HOME"), std::string::npos);
    EXPECT_NE(saidOf("/dev/null/torrance").find("/dev/null/torrance"), std::string::npos);
}

} // namespace
} // namespace torrance
