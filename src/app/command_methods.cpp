#include "app/command_methods.h"

#include "brdf/method.h"
#include "brdf/selection.h"
#include "core/error.h"
#include "core/read_file.h"
#include "core/standard_output.h"
#include "files/json_write.h"
#include "study/measured_methods.h"
#include "study/stability_atlas.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

using namespace brdf;

struct Options
{
    bool markdown = false;
    std::string measured;
};

std::string formulaOf(const Method& method)
{
    return std::holds_alternative<NoFormula>(method.formula) ? "" : functionName(method);
}

std::string glslOf(const Method& method)
{
    return hasShadingFunction(method.slot) || !method.file.empty() ? "shaders/" + glslPath(method) : "";
}

/// Ids of the presets that use the method: "standard, gltf".
std::string presetsOf(const Method& method)
{
    std::string ids;
    for (const Preset& preset : allPresets())
        if (preset[method.slot] == &method)
            ids += (ids.empty() ? "" : ", ") + std::string(preset.id);
    return ids;
}

// A line for each quirk and parameter of the preset's model.
std::string optionsText(const Preset& preset)
{
    std::string text;
    for (const ModelOption& option : allModelOptions())
        if (option.model == preset.model->id)
            text += fmt::format("    --{} {}: {}\n", option.isQuirk() ? "quirk" : "parameter", option.id, option.text);
    return text;
}

std::string plainText()
{
    std::string text;
    for (const Slot slot : allSlots()) {
        text += fmt::format("{}\n", slotName(slot));
        for (const Method& method : allMethods())
            if (method.slot == slot)
                text += fmt::format("  {:<18} {}\n", method.id, method.citation);
    }
    text += "presets\n";
    for (const Preset& preset : allPresets())
        text += fmt::format("  {:<22} {}\n", preset.id, preset.description) + optionsText(preset);
    return text;
}

std::string functionsOf(const Method& method)
{
    const std::string functions = formulaOf(method).empty() ? "judged by image" : "`" + formulaOf(method) + "`";
    return glslOf(method).empty() ? functions : functions + ", `" + glslOf(method) + "`";
}

using Measured = std::vector<MeasuredMethod>;

std::string errorText(const std::optional<double>& error)
{
    if (!error)
        return "not evaluated";
    return std::isfinite(*error) ? fmt::format("{:.2g}", *error) : "not finite";
}

// Three cells: rounding in 32 and in 16 bits, model error.
std::string measuredCells(const Method& method, const Measured& measured)
{
    const auto found = std::ranges::find(measured, methodName(method), &MeasuredMethod::method);
    if (found == measured.end())
        return " | | |";
    return fmt::format(" {} | {} | {} |", errorText(found->fp32), errorText(found->fp16), found->models);
}

std::string markdownOfSlot(Slot slot, const Measured& measured)
{
    std::string text = fmt::format("\n## {}\n\n", slotName(slot));
    text += "| method | source | approximates | domain | reciprocal | gains energy | preset | functions |";
    text += measured.empty() ? "\n|---|---|---|---|---|---|---|---|\n"
                             : " fp32 | fp16 | model error |\n|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const Method& method : allMethods())
        if (method.slot == slot)
            text += fmt::format("| `{}` | {} | {} | {} | {} | {} | {} | {} |{}\n", method.id, method.citation,
                                method.approximates, domainText(method.domain), method.reciprocal ? "yes" : "no",
                                method.gainsEnergy ? "yes" : "no", presetsOf(method), functionsOf(method),
                                measured.empty() ? "" : measuredCells(method, measured));
    return text;
}

constexpr const char* kAboutMeasured =
    "\n*fp32* and *fp16* are the greatest errors of the method's GLSL in that precision against its formula in double, "
    "*model error* that of the formula against what it approximates (plus 1 % of the greatest value of a cell, the "
    "worst "
    "and the root of the mean square), over angles down to 1e-4 and all roughnesses, also outside of the domain: "
    "`torrance stability --table docs/measured.csv` measured them.\n";

std::string markdown(const Measured& measured)
{
    std::string text = "# Shading methods\n\n"
                       "Written by `torrance methods --markdown` from the registry (`src/brdf/methods.cpp`). An empty "
                       "*approximates* means that the method is the exact form of what it names.\n\n"
                       "| preset | |\n|---|---|\n";
    for (const Preset& preset : allPresets())
        text += fmt::format("| `{}` | {} |\n", preset.id, preset.description);
    text += "\n| preset | option | |\n|---|---|---|\n";
    for (const Preset& preset : allPresets())
        for (const ModelOption& option : allModelOptions())
            if (option.model == preset.model->id)
                text += fmt::format("| `{}` | `--{} {}` | {} |\n", preset.id, option.isQuirk() ? "quirk" : "parameter",
                                    option.id, option.text);
    if (!measured.empty())
        text += kAboutMeasured;
    for (const Slot slot : allSlots())
        text += markdownOfSlot(slot, measured);
    return text;
}

Json toJson(const Method& method)
{
    return Json::Object{{"slot", std::string(slotName(method.slot))},
                        {"id", std::string(method.id)},
                        {"citation", std::string(method.citation)},
                        {"approximates", std::string(method.approximates)},
                        {"domain", domainText(method.domain)},
                        {"reciprocal", method.reciprocal},
                        {"gains_energy", method.gainsEnergy},
                        {"formula", formulaOf(method)},
                        {"glsl", glslOf(method)}};
}

Json toJson(const Preset& preset)
{
    Json::Object object = {{"id", std::string(preset.id)}, {"description", std::string(preset.description)}};
    for (const Slot slot : allSlots())
        if (const Method* method = preset[slot])
            object.emplace_back(slotName(slot), std::string(method->id));
    return object;
}

Json registryJson()
{
    Json::Array methods, presets;
    for (const Method& method : allMethods())
        methods.push_back(toJson(method));
    for (const Preset& preset : allPresets())
        presets.push_back(toJson(preset));
    return Json::Object{{"methods", std::move(methods)}, {"presets", std::move(presets)}};
}

void declare(CLI::App& app, Options& options)
{
    app.add_flag("--markdown", options.markdown, "Print the tables of docs/methods.md");
    app.add_option("--measured", options.measured,
                   "With --markdown: add the errors of this table, as torrance stability --table writes it")
        ->type_name("CSV");
}

Measured measuredOf(const Options& options)
{
    if (options.measured.empty())
        return {};
    if (!options.markdown)
        throw usageError("--measured is for --markdown", "give both");
    const std::vector<std::byte> bytes = readFile(options.measured);
    return readMeasured({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, options.measured);
}

ExitCode run(const Options& options, const GlobalOptions& global)
{
    const Measured measured = measuredOf(options);
    if (!global.json.empty())
        writeJson(global.json, registryJson());
    if (global.json != "-") // standard output holds one result
        writeStandardOutput(options.markdown ? markdown(measured) : plainText());
    return ExitCode::success;
}

} // namespace

Command methodsCommand()
{
    return makeCommand<Options>("methods", "List the shading methods and presets that can be chosen", declare, run);
}

} // namespace torrance
