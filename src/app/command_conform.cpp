#include "app/command_conform.h"

#include "app/device_option.h"
#include "app/option_value.h"
#include "core/atomic_write.h"
#include "core/log.h"
#include "core/standard_output.h"
#include "files/json_write.h"
#include "gpu/shader_folder.h"
#include "study/conformance_report.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace torrance {
namespace {

struct Options
{
    std::string folder = "conformance", only, device;
    bool validation = false;
};

void declare(CLI::App& app, Options& options)
{
    app.add_option("-o,--output", options.folder,
                   "Folder for the reports conform.html and conform.xml (default: conformance)")
        ->type_name("DIR");
    addChoice(app, "--only", options.only, conformanceGroupNames(), "One group of cases (default: all)");
    declareDeviceOption(app, options.device);
    app.add_flag("--validation", options.validation,
                 "Turn Vulkan's validation layer on; a case fails when it has something to say")
        ->group("Device");
}

// Before anything is drawn: a folder that cannot be made is known at once.
void makeFolder(const std::string& folder)
{
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure)
        throw writeError(folder, "cannot make the folder: " + failure.message(), "give another one to -o");
}

double worstOf(const ConformanceGroup& group)
{
    return std::ranges::max(group.results, {}, &ConformanceResult::excess).excess;
}

std::size_t failuresOf(const ConformanceGroup& group)
{
    return static_cast<std::size_t>(std::ranges::count_if(group.results, [](const auto& r) { return !r.passed(); }));
}

// One line a group, and one for each case that failed; the reports have the numbers.
std::string linesOf(const ConformanceGroup& group)
{
    std::string text = fmt::format("{}: {}, {} cases, greatest error {:.3g} of what is allowed\n", group.name,
                                   group.passed() ? "pass" : "FAIL", group.results.size(), worstOf(group));
    for (const ConformanceResult& result : group.results)
        if (!result.passed())
            text += "  FAIL " + oneLine(result.name + ": " + shortFault(result)) + "\n";
    return text;
}

Json summaryOf(const std::vector<ConformanceGroup>& groups, const gpu::DeviceDescription& device)
{
    Json::Array all;
    for (const ConformanceGroup& group : groups)
        all.push_back(Json::Object{{"name", group.name},
                                   {"cases", group.results.size()},
                                   {"failed", failuresOf(group)},
                                   {"worst", worstOf(group)}});
    return Json::Object{{"device", device.name}, {"driver", device.driverVersion}, {"groups", all}};
}

ExitCode run(const Options& options, const GlobalOptions& global)
{
    const gpu::Device device = openDevice(options.device, global, options.validation);
    makeFolder(options.folder);
    gpu::ShaderLibrary shaders(gpu::shaderFolder(), cacheFolder(global));
    Renderer renderer(device, shaders, cacheFolder(global));
    const std::vector<std::string> names = options.only.empty() ? conformanceGroupNames() : std::vector{options.only};
    const std::vector<ConformanceGroup> groups =
        runConformance(device, shaders, renderer, names, [&](const ConformanceGroup& group) {
            global.json == "-" ? logInfo(linesOf(group)) : writeStandardOutput(linesOf(group));
        });
    const std::filesystem::path folder = options.folder;
    writeFile(folder / "conform.xml", junitText("torrance conform", conformanceSuites(groups)));
    writeFile(folder / "conform.html", htmlText(conformanceReport(groups, device.description)));
    writeJson(global.json, summaryOf(groups, device.description));
    return std::ranges::all_of(groups, &ConformanceGroup::passed) ? ExitCode::success : ExitCode::checkFailed;
}

} // namespace

Command conformCommand()
{
    return makeCommand<Options>("conform", "Hold what a device draws against what the CPU computes", declare, run);
}

} // namespace torrance
