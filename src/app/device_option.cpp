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
    gpu::prepareDriverEnvironment(cacheFolder(global));
    gpu::Device device({.choice = choice, .validation = validation});
    logInfo("device: " + device.description.name + ", " + device.description.driver + " " +
            device.description.driverVersion);
    return device;
}

} // namespace torrance
