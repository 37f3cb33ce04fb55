// The Vulkan devices and drivers of this machine, for --version.
#pragma once

#include <string>

namespace torrance {

/// A line per device, "Vulkan 1.3.230: NAME, DRIVER VERSION"; one line that says why where there is none.
std::string driverText();

} // namespace torrance
