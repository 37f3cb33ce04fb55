// Makes the tables of share/torrance while Torrance is built: make_dfg_table ggx_smith_corr|ggx_burley FILE
#include "brdf/dfg.h"
#include "brdf/integration_map.h"
#include "core/error.h"
#include "core/log.h"
#include "prepare/dfg_table.h"

#include <string_view>

int main(int argc, char** argv)
{
    using namespace torrance;
    const std::string_view lobe = argc == 3 ? argv[1] : "";
    if (lobe != "ggx_smith_corr" && lobe != "ggx_burley") {
        logError("usage: make_dfg_table ggx_smith_corr|ggx_burley FILE");
        return static_cast<int>(ExitCode::usage);
    }
    try {
        writeDfgTable(argv[2], lobe == "ggx_burley"
                                   ? makeDfgTable(&brdf::integrationMap, kIntegrationMapSize, kIntegrationMapSize)
                                   : makeDfgTable(&brdf::DFG_table));
        return static_cast<int>(ExitCode::success);
    } catch (const Error& error) {
        logError(error.what());
        return static_cast<int>(error.exitCode);
    }
}
