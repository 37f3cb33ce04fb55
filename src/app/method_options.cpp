#include "app/method_options.h"

#include "app/option_value.h"
#include "core/error.h"

#include <CLI/CLI.hpp>

namespace torrance {
namespace {

std::vector<std::string> methodIds(brdf::Slot slot)
{
    std::vector<std::string> ids;
    for (const brdf::Method& method : brdf::allMethods())
        if (method.slot == slot)
            ids.emplace_back(method.id);
    return ids;
}

std::string optionName(brdf::Slot slot)
{
    std::string name = "--" + std::string(brdf::slotName(slot));
    for (char& c : name)
        if (c == '_')
            c = '-';
    return name;
}

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

} // namespace

void declareMethodOptions(CLI::App& app, MethodOptions& options)
{
    std::vector<std::string> presets;
    for (const brdf::Preset& preset : brdf::allPresets())
        presets.emplace_back(preset.id);
    addChoice(app, "--preset", options.preset, presets, "Methods of shading")->group("Methods");
    const brdf::Preset& standard = *brdf::findPreset("standard");
    for (const brdf::Slot slot : brdf::allSlots())
        if (standard[slot])
            addChoice(app, optionName(slot), options.overrides[slot], methodIds(slot), "Instead of the preset's")
                ->group("Methods");
}

brdf::Preset chooseMethods(const MethodOptions& options)
{
    brdf::Preset preset = startingPreset(options);
    for (const auto& [slot, id] : options.overrides) {
        if (id.empty() || slot == brdf::Slot::model)
            continue;
        if (!preset[slot])
            throw usageError("the preset " + std::string(preset.id) + " takes no " + optionName(slot) +
                                 ": its source defines that by itself, or not at all",
                             "leave it out, or use --preset standard");
        preset[slot] = brdf::findMethod(slot, id);
    }
    return preset;
}

} // namespace torrance
