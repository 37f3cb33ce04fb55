// Makes share/torrance/dfg_ggx_smith_corr.bin while Torrance is built: make_dfg_table FILE
#include "core/error.h"
#include "core/log.h"
#include "prepare/dfg_table.h"

int main(int argc, char** argv)
{
    using namespace torrance;
    if (argc != 2) {
        logError("usage: make_dfg_table FILE");
        return static_cast<int>(ExitCode::usage);
    }
    try {
        writeDfgTable(argv[1], makeDfgTable());
        return static_cast<int>(ExitCode::success);
    } catch (const Error& error) {
        logError(error.what());
        return static_cast<int>(error.exitCode);
    }
}
