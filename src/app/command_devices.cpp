#include "app/command_devices.h"

#include "app/device_option.h"
#include "core/standard_output.h"
#include "files/json_write.h"

namespace torrance {
namespace {

struct Options
{
};

void declare(CLI::App&, Options&) {}

std::string describedInWords(const gpu::DeviceDescription& device, std::size_t index)
{
    std::string text = std::to_string(index) + "  " + device.name + " (" + device.kind + "), Vulkan " +
                       device.apiVersion + ", " + device.driver + " " + device.driverVersion + "\n";
    for (const std::string& part : device.missing)
        text += "   lacks " + part + "\n";
    if (device.missing.empty())
        text += "   can be used\n";
    return text;
}

Json describedAsJson(const gpu::DeviceDescription& device)
{
    Json::Array missing(device.missing.begin(), device.missing.end());
    return Json::Object{{"name", device.name},
                        {"kind", device.kind},
                        {"vulkan", device.apiVersion},
                        {"driver", device.driver},
                        {"driver_version", device.driverVersion},
                        {"missing", missing}};
}

ExitCode run(const Options&, const GlobalOptions& global)
{
    const std::vector<gpu::DeviceDescription> devices = gpu::listDevices();
    std::string text;
    Json::Array json;
    bool usable = false;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        text += describedInWords(devices[i], i);
        json.push_back(describedAsJson(devices[i]));
        usable |= devices[i].missing.empty();
    }
    if (global.json != "-")
        writeStandardOutput(text);
    writeJson(global.json, json);
    if (!usable)
        throw Error(ExitCode::noDevice,
                    "no usable Vulkan device; install mesa-vulkan-drivers for a machine without a GPU");
    return ExitCode::success;
}

} // namespace

Command devicesCommand()
{
    return makeCommand<Options>("devices", "List the Vulkan devices, each with what is missing on it", declare, run);
}

} // namespace torrance
