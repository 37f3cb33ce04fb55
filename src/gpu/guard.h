// Vulkan's exceptions as this project's: one line, the right exit code.
#pragma once

#include "core/error.h"
#include "gpu/device.h"

namespace torrance::gpu {

/// Runs `work`; a failure of the device becomes an Error (deviceFailure) that names it.
template <typename Work>
auto guarded(const Device& device, Work&& work)
{
    try {
        return work();
    } catch (const vk::OutOfHostMemoryError&) {
        throw Error(ExitCode::deviceFailure,
                    device.description.name + ": out of memory; choose a smaller picture or scene");
    } catch (const vk::OutOfDeviceMemoryError&) {
        throw Error(ExitCode::deviceFailure,
                    device.description.name + ": out of device memory; choose a smaller picture or scene");
    } catch (const vk::DeviceLostError&) {
        throw Error(ExitCode::deviceFailure, device.description.name +
                                                 ": the device was lost: its driver has reset it, or it is gone; start "
                                                 "again, or try another device or driver");
    } catch (const vk::SystemError& error) {
        throw Error(ExitCode::deviceFailure,
                    device.description.name + ": " + error.what() + "; try another device or driver");
    }
}

} // namespace torrance::gpu
