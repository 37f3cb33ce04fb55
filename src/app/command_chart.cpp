#include "app/command_chart.h"

#include "app/chart_output.h"
#include "app/chart_session.h"
#include "app/option_value.h"
#include "core/atomic_write.h"
#include "core/error.h"
#include "core/log.h"
#include "core/nearest_name.h"
#include "core/standard_output.h"
#include "study/chart_methods_page.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <sstream>

namespace torrance {
namespace {

namespace fs = std::filesystem;

struct Options
{
    std::string output;
    std::string slots;
    MeasuringOptions measuring;
};

void declare(CLI::App& app, Options& o)
{
    app.add_option("-o,--output", o.output, "Folder for the chart: HTML, SVG, CSV and JSON")
        ->type_name("DIR")
        ->required();
    app.add_option("--slot", o.slots, "Slots whose methods are charted, separated by commas (default: all)")
        ->type_name("NAMES");
    declareMeasuringOptions(app, o.measuring);
}

std::vector<brdf::Slot> chosenSlots(const std::string& names)
{
    std::vector<brdf::Slot> slots;
    if (names.empty()) {
        const auto all = brdf::allSlots();
        return {all.begin(), all.end()};
    }
    std::vector<std::string> known;
    for (const brdf::Slot slot : brdf::allSlots())
        known.emplace_back(brdf::slotName(slot));
    std::istringstream stream(names);
    for (std::string name; std::getline(stream, name, ',');) {
        const std::optional<brdf::Slot> slot = brdf::findSlot(name);
        if (!slot) {
            const std::string nearest = nearestName(name, known);
            throw usageError("--slot: unknown slot " + name,
                             nearest.empty() ? "known are " + listed(known) : "did you mean " + nearest + "?");
        }
        if (std::ranges::find(slots, *slot) == slots.end())
            slots.push_back(*slot);
    }
    return slots;
}

fs::path madeFolder(const std::string& name)
{
    std::error_code failure;
    fs::create_directories(name, failure);
    if (!fs::is_directory(name))
        throw writeError(name, failure ? failure.message() : "is not a folder", "choose another folder");
    return name;
}

ExitCode run(const Options& options, const GlobalOptions& global)
{
    const std::vector<brdf::Slot> slots = chosenSlots(options.slots);
    const fs::path folder = madeFolder(options.output);
    const std::string part = (folder / "methods.part").string();
    const MethodChart chart = measureMethods(options.measuring, global, slots, part);
    writeChart(folder, "methods", methodsPage(chart));
    writeFile(folder / "methods.csv", methodsCsv(chart.table));
    writeFile(folder / "methods.measured.json", jsonText(asJson(chart.table)));
    fs::remove(part);
    return ExitCode::success;
}

} // namespace

Command chartCommand()
{
    return makeCommand<Options>("chart", "Chart what shading methods cost against how far off they are", declare, run);
}

} // namespace torrance
