// The measured table of methods that a command reads.
#pragma once

#include "gpu/device.h"
#include "plan/method_table.h"

#include <string>

namespace CLI {
class App;
}

namespace torrance {

/// --methods: a name for loadMethodTable.
void declareMethodTableOption(CLI::App& app, std::string& name);

struct NamedMethodTable
{
    MethodTable table;
    std::string hash; // of the file
};

/// `name` is a file of torrance calibrate, which must be of this device: Error (input) otherwise. "shipped" is the one
/// that comes with the program, of lavapipe; `anyDevice` reads it whatever the device is, for it is the same choice
/// everywhere that a command line without a name means.
NamedMethodTable loadMethodTable(const std::string& name, const gpu::DeviceDescription& device, bool anyDevice);

} // namespace torrance
