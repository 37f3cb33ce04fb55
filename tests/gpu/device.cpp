#include "gpu/device.h"

#include "core/error.h"
#include "gpu/guard.h"
#include "test_device.h"
#include "tests/mapped_lines.h"

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>

namespace torrance {
namespace {

TEST(Device, IsDescribedAndUsable)
{
    EXPECT_FALSE(test::device().description.name.empty());
    EXPECT_TRUE(test::device().description.missing.empty());
}

TEST(Device, DriversOfCardsAreLeftOutWhereThereAreNone)
{
    test::device();
    if (std::filesystem::exists("/dev/dri"))
        GTEST_SKIP() << "there may be cards here: every driver is asked";
    if (std::getenv("VK_DRIVER_FILES") || std::getenv("VK_ICD_FILENAMES") || std::getenv("VK_LOADER_DRIVERS_SELECT"))
        GTEST_SKIP() << "drivers were chosen by name";
    for (const char* driver : {"libvulkan_intel", "libvulkan_radeon", "libvulkan_nouveau", "libvulkan_virtio"})
        EXPECT_EQ(test::mappedLines(driver), 0u) << driver;
}

TEST(Device, ValidationSeesADeliberateMistake)
{
    // A device of its own: this message is wanted.
    const gpu::Device device({.choice = test::device().description.name, .validation = true});
    const vk::BufferCreateInfo noUsage = {.size = 16};
    const vk::raii::Buffer buffer(device.handle, noUsage);
    EXPECT_FALSE(device.validationMessages().empty());
}

TEST(Device, AnUnknownNameIsSaidWithItsExitCode)
{
    try {
        const gpu::Device device({.choice = "no such device", .validation = false});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.exitCode, ExitCode::noDevice);
        EXPECT_NE(std::string(error.what()).find("no such device"), std::string::npos);
    }
}

TEST(Device, FailuresAreSaidInOneLineWithTheirExitCode)
{
    const auto codeOf = [](auto&& failure) {
        try {
            gpu::guarded(test::device(), [&]() -> int { throw failure; });
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(test::device().description.name), std::string::npos);
            return error.exitCode;
        }
        return ExitCode::success;
    };
    EXPECT_EQ(codeOf(vk::OutOfDeviceMemoryError("planted")), ExitCode::deviceFailure);
    EXPECT_EQ(codeOf(vk::OutOfHostMemoryError("planted")), ExitCode::deviceFailure);
    EXPECT_EQ(codeOf(vk::DeviceLostError("planted")), ExitCode::deviceFailure);
    EXPECT_THROW(gpu::guarded(test::device(), []() -> int { throw usageError("planted", ""); }), Error);
}

} // namespace
} // namespace torrance
