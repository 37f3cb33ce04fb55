#include "app/command_chart.h"

#include "app/chart_output.h"
#include "app/chart_scene.h"
#include "app/chart_session.h"
#include "app/device_option.h"
#include "app/method_table_option.h"
#include "app/option_value.h"
#include "app/output_folder.h"
#include "core/atomic_write.h"
#include "core/error.h"
#include "core/nearest_name.h"
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
    std::string methods;
    MeasuringOptions measuring;
    SceneChartOptions scene;
};

void declare(CLI::App& app, Options& o)
{
    app.add_option("-o,--output", o.output, "Folder for the chart: HTML, SVG, CSV and JSON")
        ->type_name("DIR")
        ->required();
    app.add_option("--slot", o.slots, "Slots whose methods are charted, separated by commas (default: all)")
        ->type_name("NAMES");
    app.add_option(
           "--methods", o.methods,
           "Chart this table of torrance calibrate, of this device, instead of measuring; shipped: the one that "
           "comes with the program, of lavapipe")
        ->type_name("FILE");
    declareMeasuringOptions(app, o.measuring);
    declareSceneChartOptions(app, o.scene);
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

MethodChart chartOfTable(const Options& options, const GlobalOptions& global)
{
    const gpu::DeviceDescription device = openDevice(options.measuring.device, global).description;
    return {.table = loadMethodTable(options.methods, device, false).table, .pictures = {}};
}

void writeMethods(const MethodChart& chart, const fs::path& folder)
{
    writeChart(folder, "methods", methodsPage(chart));
    writeFile(folder / "methods.csv", methodsCsv(chart.table));
    writeFile(folder / "methods.measured.json", jsonText(asJson(chart.table)));
}

ExitCode run(const Options& options, const GlobalOptions& global)
{
    const std::vector<brdf::Slot> slots = chosenSlots(options.slots);
    const bool ofScene = !options.scene.scene.files.empty() || !options.scene.scene.primitive.empty();
    if (!options.slots.empty() && (ofScene || !options.methods.empty()))
        throw usageError("--slot is of methods that are measured, and goes with no scene and no --methods",
                         "leave one of them out");
    if (!options.methods.empty() && (ofScene || options.measuring.resume))
        throw usageError("--methods is charted as it is, without a scene and without --resume",
                         "leave one of them out");
    if (!ofScene && !options.scene.resolution.empty())
        throw usageError("--resolution is of a scene's pictures", "name a scene, or leave it out");
    if (!ofScene && options.scene.tolerances != "standard")
        throw usageError("--tolerance is of a scene's plans", "name a scene, or leave it out");
    const fs::path folder = madeFolder(options.output);
    if (ofScene) {
        chartScene(options.scene, options.measuring, global, folder);
        return ExitCode::success;
    }
    if (!options.methods.empty()) {
        writeMethods(chartOfTable(options, global), folder);
        return ExitCode::success;
    }
    const std::string part = (folder / "methods.part").string();
    writeMethods(measureMethods(options.measuring, global, slots, part), folder);
    fs::remove(part);
    return ExitCode::success;
}

} // namespace

Command chartCommand()
{
    return makeCommand<Options>(
        "chart", "Chart what shading methods, or the plans of a scene, cost against how far off they are", declare,
        run);
}

} // namespace torrance
