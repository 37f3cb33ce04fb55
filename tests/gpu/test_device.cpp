#include "test_device.h"

#include "gpu/driver_environment.h"
#include "gpu/shader_folder.h"

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <gtest/gtest.h>
#include <memory>

namespace torrance::test {
namespace {

// The driver and the layer stay in the process: the leak checker can then name and suppress what is theirs.
void keepLoaded(const char* library)
{
    dlopen(library, RTLD_NOW | RTLD_NODELETE);
}

std::unique_ptr<gpu::Device>& slot()
{
    static std::unique_ptr<gpu::Device> device;
    return device;
}

// One validation message is a failed test.
class ValidationListener : public testing::EmptyTestEventListener
{
    void OnTestStart(const testing::TestInfo&) override { seen = slot() ? slot()->validationMessages().size() : 0; }
    void OnTestEnd(const testing::TestInfo&) override
    {
        if (!slot())
            return;
        const auto messages = slot()->validationMessages();
        for (std::size_t i = seen; i < messages.size(); ++i)
            ADD_FAILURE() << "validation: " << messages[i];
    }
    std::size_t seen = 0;
};

} // namespace

gpu::Device& device()
{
    if (!slot()) {
        const char* choice = std::getenv("TORRANCE_TEST_DEVICE");
        slot() = std::make_unique<gpu::Device>(gpu::DeviceOptions{.choice = choice ? choice : "", .validation = true});
    }
    return *slot();
}

gpu::ShaderLibrary& shaders()
{
    static gpu::ShaderLibrary library(gpu::shaderFolder(), {});
    return library;
}

} // namespace torrance::test

// What the leak checker is to pass over: the layer and the driver keep what they allocate until the process ends.
extern "C" const char* __lsan_default_suppressions()
{
    return "leak:libVkLayer_khronos_validation.so\nleak:libvulkan_lvp.so\n";
}

int main(int argc, char** argv)
{
    torrance::test::keepLoaded("libvulkan_lvp.so");
    torrance::test::keepLoaded("libVkLayer_khronos_validation.so");
    // A cache of Mesa's in the build tree: the second test that needs a pipeline does not pay for its JIT again.
    torrance::gpu::prepareDriverEnvironment(std::filesystem::path(TORRANCE_BINARY_DIR) / "test-cache");
    testing::InitGoogleTest(&argc, argv);
    testing::UnitTest::GetInstance()->listeners().Append(new torrance::test::ValidationListener);
    const int result = RUN_ALL_TESTS();
    torrance::test::slot().reset();
    return result;
}
