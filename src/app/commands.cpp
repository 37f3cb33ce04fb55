#include "app/commands.h"

#include "app/command_bench.h"
#include "app/command_calibrate.h"
#include "app/command_chart.h"
#include "app/command_compare.h"
#include "app/command_conform.h"
#include "app/command_devices.h"
#include "app/command_inspect.h"
#include "app/command_methods.h"
#include "app/command_probe.h"
#include "app/command_reference.h"
#include "app/command_render.h"
#include "app/command_stability.h"
#include "app/command_verify.h"
#include "app/command_view.h"
#include "app/command_warm.h"

namespace torrance {

std::vector<Command> allCommands()
{
    return {renderCommand(),  viewCommand(),      referenceCommand(), inspectCommand(), compareCommand(),
            methodsCommand(), probeCommand(),     benchCommand(),     chartCommand(),   calibrateCommand(),
            conformCommand(), stabilityCommand(), verifyCommand(),    devicesCommand(), warmCommand()};
}

} // namespace torrance
