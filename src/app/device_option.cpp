#include "app/device_option.h"

#include "core/disk_cache.h"
#include "core/log.h"
#include "gpu/driver_environment.h"

#include <CLI/CLI.hpp>

namespace torrance {

void declareDeviceOption(CLI::App& app, std::string& choice)
{
    app.add_option("--device", choice,
                   "Vulkan device: a number or a part of a name as 'torrance devices' lists them, or cpu")
        ->group("Device")
        ->type_name("INDEX|NAME|cpu");
}

std::filesystem::path cacheFolder(const GlobalOptions& global)
{
    return global.noCache ? std::filesystem::path() : userCacheFolder();
}

gpu::Device openDevice(const std::string& choice, const GlobalOptions& global, bool validation)
{
    return finishOpeningDevice(startOpeningDevice(choice, global, validation));
}

std::future<gpu::Device> startOpeningDevice(const std::string& choice, const GlobalOptions& global, bool validation)
{
    gpu::prepareDriverEnvironment(cacheFolder(global)); // here: no other thread may read the environment meanwhile
    return std::async(std::launch::async, [=] { return gpu::Device({.choice = choice, .validation = validation}); });
}

gpu::Device finishOpeningDevice(std::future<gpu::Device> opening)
{
    gpu::Device device = opening.get();
    logInfo("device: " + device.description.name + ", " + device.description.driver + " " +
            device.description.driverVersion);
    return device;
}

} // namespace torrance
