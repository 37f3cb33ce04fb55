#include "app/driver_text.h"

#include "core/error.h"
#include "gpu/device.h"

namespace torrance {

std::string driverText()
{
    try {
        std::string text;
        for (const gpu::DeviceDescription& device : gpu::listDevices())
            text += "Vulkan " + device.apiVersion + ": " + device.name + ", " + device.driver + " " +
                    device.driverVersion + "\n";
        return text.empty() ? "Vulkan: no device\n" : text;
    } catch (const Error& error) {
        return std::string("Vulkan: ") + error.what() + "\n";
    }
}

} // namespace torrance
