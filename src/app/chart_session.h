// What `torrance chart` and `torrance calibrate` share: measuring methods, with what is finished kept on disk.
#pragma once

#include "app/command.h"
#include "app/environment_option.h"
#include "study/chart_methods.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace torrance {

struct MeasuringOptions
{
    double seconds = 2.0;
    bool resume = false;
    std::string device;
    EnvironmentOptions environment;
};

/// --seconds, --resume, the device and the environment.
void declareMeasuringOptions(CLI::App& app, MeasuringOptions& options);

/// Measures the slots. What is finished is kept in `part` and removed from there by the caller, when it has written
/// what it wants; an interruption ends the process by its signal, with `part` left for --resume.
MethodChart measureMethods(const MeasuringOptions& options, const GlobalOptions& global,
                           const std::vector<brdf::Slot>& slots, const std::string& part);

} // namespace torrance
