#include "app/method_table_option.h"

#include "core/content_hash.h"
#include "core/data_folder.h"
#include "core/read_file.h"
#include "study/method_table_file.h"

#include <CLI/CLI.hpp>

namespace torrance {

void declareMethodTableOption(CLI::App& app, std::string& name)
{
    app.add_option("--methods", name,
                   "The table of torrance calibrate that a tolerance chooses from (default shipped: of lavapipe)")
        ->group("Methods")
        ->type_name("FILE");
}

NamedMethodTable loadMethodTable(const std::string& name, const gpu::DeviceDescription& device, bool anyDevice)
{
    const bool shipped = name == "shipped";
    const std::string file = shipped ? (dataFolder() / "methods.measured.json").string() : name;
    const std::vector<std::byte> bytes = readFile(file);
    NamedMethodTable named = {parseMethodTable({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file),
                              hashBytes(bytes).hex()};
    if (!shipped || !anyDevice)
        requireDevice(named.table, file, device.name, device.driver + " " + device.driverVersion);
    return named;
}

} // namespace torrance
