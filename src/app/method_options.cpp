#include "app/method_options.h"

#include "app/option_value.h"
#include "brdf/slot_option.h"
#include "core/error.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>

namespace torrance {
namespace {

// A source's model stands for the whole of its preset; the model gltf is that of the other presets.
brdf::Preset startingPreset(const MethodOptions& options)
{
    const brdf::Preset& preset = *brdf::findPreset(options.preset);
    const auto chosen = options.overrides.find(brdf::Slot::model);
    if (chosen == options.overrides.end() || chosen->second.empty() || chosen->second == preset.model->id)
        return preset;
    if (!brdf::isComposed(preset))
        throw usageError("the preset " + options.preset + " has a model of its own, and not " + chosen->second,
                         "leave out --model or --preset");
    for (const brdf::Preset& other : brdf::allPresets())
        if (other.model->id == chosen->second)
            return other;
    return preset;
}

// "a, b" of the options that the model has.
std::string optionsOf(const brdf::Preset& preset, bool quirks)
{
    std::string text;
    for (const brdf::ModelOption& option : brdf::allModelOptions())
        if (option.model == preset.model->id && option.isQuirk() == quirks)
            text += (text.empty() ? "" : ", ") + std::string(option.id);
    return text;
}

const brdf::ModelOption& modelOption(const brdf::Preset& preset, const std::string& id, bool quirk)
{
    const brdf::ModelOption* option = brdf::findModelOption(preset, id);
    if (option && option->isQuirk() == quirk)
        return *option;
    const std::string known = optionsOf(preset, quirk), kind = quirk ? "quirk" : "parameter";
    throw usageError("the preset " + std::string(preset.id) + " has no " + kind + " " + id,
                     known.empty() ? "leave out --" + kind + ": it has none" : "known are " + known);
}

void setParameter(const std::string& choice, brdf::Preset& preset)
{
    const std::size_t equals = choice.find('=');
    const brdf::ModelOption& option = modelOption(preset, choice.substr(0, equals), false);
    const std::string value = equals == std::string::npos ? "" : choice.substr(equals + 1);
    const double number = parseNumbers("--parameter " + std::string(option.id), value, 1, 1).front();
    if (!(number >= 0.0 && number <= option.greatest))
        throw usageError("--parameter " + choice + " is out of range",
                         fmt::format("it lies between 0 and {}", option.greatest));
    preset.options.*std::get<double brdf::ModelOptions::*>(option.member) = number;
}

} // namespace

std::vector<std::string> methodIds(brdf::Slot slot)
{
    std::vector<std::string> ids;
    for (const brdf::Method& method : brdf::allMethods())
        if (method.slot == slot)
            ids.emplace_back(method.id);
    return ids;
}

void declareModelChoices(CLI::App& app, ModelChoices& choices)
{
    app.add_option("--quirk", choices.quirks,
                   "Readings of a source system to the letter, such as double-fresnel; torrance methods lists them")
        ->group("Methods")
        ->type_name("NAME,...");
    app.add_option("--parameter", choices.parameters, "Numbers of a source system, such as reflectivity=0.5")
        ->group("Methods")
        ->type_name("NAME=VALUE,...");
}

void applyModelChoices(const ModelChoices& choices, brdf::Preset& preset)
{
    for (const std::string& id : splitAtCommas(choices.quirks))
        preset.options.*std::get<bool brdf::ModelOptions::*>(modelOption(preset, id, true).member) = true;
    for (const std::string& choice : splitAtCommas(choices.parameters))
        setParameter(choice, preset);
}

void declareMethodOptions(CLI::App& app, MethodOptions& options)
{
    std::vector<std::string> presets;
    for (const brdf::Preset& preset : brdf::allPresets())
        presets.emplace_back(preset.id);
    addChoice(app, "--preset", options.preset, presets, "Methods of shading")->group("Methods");
    const brdf::Preset& standard = *brdf::findPreset("standard");
    for (const brdf::Slot slot : brdf::allSlots())
        if (standard[slot])
            addChoice(app, brdf::slotOption(slot), options.overrides[slot], methodIds(slot), "Instead of the preset's")
                ->group("Methods");
    declareModelChoices(app, options.model);
}

brdf::Preset chooseMethods(const MethodOptions& options)
{
    brdf::Preset preset = startingPreset(options);
    for (const auto& [slot, id] : options.overrides) {
        if (id.empty() || slot == brdf::Slot::model)
            continue;
        if (!preset[slot])
            throw usageError("the preset " + std::string(preset.id) + " takes no " + brdf::slotOption(slot) +
                                 ": its source defines that by itself, or not at all",
                             "leave it out, or use --preset standard");
        preset[slot] = brdf::findMethod(slot, id);
    }
    applyModelChoices(options.model, preset);
    return preset;
}

} // namespace torrance
