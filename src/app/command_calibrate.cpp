#include "app/command_calibrate.h"

#include "app/chart_session.h"
#include "core/atomic_write.h"
#include "core/log.h"

#include <CLI/CLI.hpp>
#include <filesystem>

namespace torrance {
namespace {

struct Options
{
    std::string output;
    MeasuringOptions measuring;
};

void declare(CLI::App& app, Options& o)
{
    app.add_option("-o,--output", o.output, "File for the table, which --methods takes")->type_name("FILE")->required();
    declareMeasuringOptions(app, o.measuring);
}

ExitCode run(const Options& options, const GlobalOptions& global)
{
    const auto all = brdf::allSlots();
    const std::string part = options.output + ".part";
    const MethodChart chart = measureMethods(options.measuring, global, {all.begin(), all.end()}, part);
    writeFile(options.output, jsonText(asJson(chart.table)));
    std::filesystem::remove(part);
    logInfo("wrote " + options.output);
    return ExitCode::success;
}

} // namespace

Command calibrateCommand()
{
    return makeCommand<Options>("calibrate", "Measure what every shading method costs here, and its error", declare,
                                run);
}

} // namespace torrance
