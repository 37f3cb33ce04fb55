#include "app/command_stability.h"

#include "app/device_option.h"
#include "app/option_value.h"
#include "app/output_folder.h"
#include "app/progress_line.h"
#include "app/stability_scene.h"
#include "core/atomic_write.h"
#include "core/log.h"
#include "core/nearest_name.h"
#include "core/standard_output.h"
#include "files/image_encoders.h"
#include "files/json_write.h"
#include "gpu/shader_folder.h"
#include "study/measured_methods.h"
#include "study/stability_atlas.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace torrance {
namespace {

namespace fs = std::filesystem;
using brdf::Method;
using gpu::Precision;

struct Options
{
    std::vector<std::string> methods;
    std::string output;
    std::vector<std::string> precisions = {"fp16", "fp32", "fp64"};
    int size = AtlasSize().map;
    std::string table;
    std::string device;
    SceneTrialOptions scene;
};

constexpr int kLeastSize = 8; // the axis of indices has a third of them below 1
constexpr int kMostSize = 256;

void declare(CLI::App& app, Options& o)
{
    declareSceneTrialOptions(app, o.scene);
    app.add_option("--method", o.methods, "Methods to look at, as ID or SLOT/ID (default: all)")->type_name("ID...");
    app.add_option("-o,--output", o.output,
                   "Folder for the reports: index.html of methods with maps and tables, scene.html of a scene")
        ->type_name("DIR");
    app.add_option("--precision", o.precisions, "fp16, fp32 and fp64 unless given")
        ->type_name("NAME...")
        ->check(CLI::IsMember({"fp16", "fp32", "fp64"}));
    app.add_option("--size", o.size, "Columns and rows of the maps (default 64)")
        ->check(CLI::Range(kLeastSize, kMostSize));
    app.add_option("--table", o.table,
                   "Write the greatest errors of all methods, on maps of their own size: docs/measured.csv, which "
                   "torrance methods --measured reads")
        ->type_name("CSV");
    declareDeviceOption(app, o.device);
}

std::vector<const Method*> sweptMethods()
{
    std::vector<const Method*> methods;
    for (const Method& method : brdf::allMethods())
        if (canSweep(method))
            methods.push_back(&method);
    return methods;
}

Error unknownMethod(const std::string& name, const std::vector<const Method*>& known)
{
    std::vector<std::string> names;
    for (const Method* method : known) {
        names.emplace_back(method->id);
        names.push_back(methodName(*method));
    }
    const std::string nearest = nearestName(name, names);
    return usageError("no method " + name + " has a function on the device",
                      nearest.empty() ? "torrance methods lists them" : "did you mean " + nearest + "?");
}

std::vector<const Method*> chosenMethods(const Options& options)
{
    const std::vector<const Method*> all = sweptMethods();
    if (options.methods.empty())
        return all;
    const auto isNamed = [](const Method* method, const std::string& name) {
        return method->id == name || methodName(*method) == name;
    };
    for (const std::string& name : options.methods)
        if (std::ranges::none_of(all, [&](const Method* method) { return isNamed(method, name); }))
            throw unknownMethod(name, all);
    std::vector<const Method*> chosen;
    for (const Method* method : all)
        if (std::ranges::any_of(options.methods, [&](const std::string& name) { return isNamed(method, name); }))
            chosen.push_back(method);
    return chosen;
}

std::vector<Precision> chosenPrecisions(const Options& options)
{
    std::vector<Precision> precisions;
    for (const Precision precision : {Precision::fp16, Precision::fp32, Precision::fp64})
        if (std::ranges::find(options.precisions, gpu::precisionName(precision)) != options.precisions.end())
            precisions.push_back(precision);
    return precisions;
}

Json toJson(const Extent& extent)
{
    if (extent.cells == 0)
        return {};
    return Json::Object{{"cells", extent.cells},
                        {"least_row", extent.leastRow},
                        {"greatest_row", extent.greatestRow},
                        {"least_cosine", extent.leastCosine},
                        {"greatest_cosine", extent.greatestCosine}};
}

Json toJson(const MethodVerdict& verdict)
{
    Json::Array precisions, models, lines;
    for (const PrecisionVerdict& p : verdict.precisions)
        precisions.push_back(Json::Object{{"precision", std::string(gpu::precisionName(p.precision))},
                                          {"refusal", p.refusal},
                                          {"worst", p.worst.error},
                                          {"above_1e-4", toJson(p.above4)},
                                          {"above_1e-2", toJson(p.above2)},
                                          {"non_finite", toJson(p.nonFinite)},
                                          {"negative", toJson(p.negative)},
                                          {"unexplained", toJson(p.unexplained)}});
    for (const ModelVerdict& m : verdict.models)
        models.push_back(
            Json::Object{{"against", std::string(m.approximated->id)}, {"worst", m.worst.error}, {"rms", m.rms}});
    for (const std::string& line : verdictLines(verdict))
        lines.emplace_back(line);
    return Json::Object{{"method", methodName(*verdict.method)},
                        {"precisions", std::move(precisions)},
                        {"models", std::move(models)},
                        {"energy", verdict.energy},
                        {"gains_energy", toJson(verdict.gainsEnergy)},
                        {"reciprocity_error", verdict.reciprocity},
                        {"verdict", std::move(lines)}};
}

void writeEntry(const fs::path& folder, const AtlasEntry& entry)
{
    writeFile(folder / entry.csvFile, entry.csv);
    for (const AtlasMap& map : entry.maps)
        writeFile(folder / map.file, encodePng(map.picture, 8));
}

std::string plainText(const AtlasEntry& entry)
{
    std::string text = entry.name + "\n";
    for (const std::string& line : entry.lines)
        text += "  " + line + "\n";
    return text;
}

ExitCode runMethods(const Options& options, const GlobalOptions& global)
{
    const std::vector<const Method*> methods = chosenMethods(options);
    const std::vector<Precision> precisions = chosenPrecisions(options);
    const fs::path folder = options.output.empty() ? fs::path() : madeFolder(options.output);
    const gpu::Device device = openDevice(options.device, global);
    gpu::ShaderLibrary shaders(gpu::shaderFolder(), cacheFolder(global));

    std::vector<AtlasEntry> entries;
    Json::Array results;
    ProgressLine progress("stability");
    for (const Method* method : methods) {
        progress.show(static_cast<int>(entries.size()), static_cast<int>(methods.size()));
        const MethodVerdict verdict = judgeMethod(device, shaders, *method, {.map = options.size}, precisions);
        results.push_back(toJson(verdict));
        entries.push_back(atlasEntry(verdict));
        if (!folder.empty())
            writeEntry(folder, entries.back());
    }
    progress.clear();
    if (!folder.empty())
        writeFile(folder / "index.html", htmlText(atlasReport(entries, device.description.name)));
    if (global.json != "-" && !global.quiet)
        for (const AtlasEntry& entry : entries)
            writeStandardOutput(plainText(entry));
    writeJson(global.json, Json::Object{{"device", device.description.name}, {"methods", std::move(results)}});
    return ExitCode::success;
}

// Of every method, so that a table is always whole.
ExitCode runTable(const Options& options, const GlobalOptions& global)
{
    const gpu::Device device = openDevice(options.device, global);
    gpu::ShaderLibrary shaders(gpu::shaderFolder(), cacheFolder(global));
    const std::vector<const Method*> methods = sweptMethods();
    std::vector<MeasuredMethod> measured;
    ProgressLine progress("stability");
    for (const Method* method : methods) {
        progress.show(static_cast<int>(measured.size()), static_cast<int>(methods.size()));
        constexpr Precision kPrecisions[] = {Precision::fp16, Precision::fp32};
        measured.push_back(measuredMethod(judgeMethod(device, shaders, *method, kMeasuredSize, kPrecisions)));
    }
    progress.clear();
    writeFile(options.table, measuredCsv(measured));
    return ExitCode::success;
}

ExitCode run(const Options& options, const GlobalOptions& global)
{
    const bool other = !options.methods.empty() || !isWithoutScene(options.scene) || !options.output.empty();
    if (!options.table.empty() && other)
        throw usageError("--table is of all methods and goes with no other choice",
                         "leave the scene, --method and -o out");
    if (!options.table.empty())
        return runTable(options, global);
    if (isWithoutScene(options.scene))
        return runMethods(options, global);
    if (!options.methods.empty())
        throw usageError("--method and a scene exclude each other", "leave one of them out");
    if (!options.output.empty())
        madeFolder(options.output);
    return runSceneTrialsOf(options.scene, options.device, options.output, global);
}

} // namespace

Command stabilityCommand()
{
    return makeCommand<Options>(
        "stability", "Find where shading methods break, in 16, 32 and 64 bits, or a scene's picture", declare, run);
}

} // namespace torrance
