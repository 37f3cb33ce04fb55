#include "app/method_options.h"

#include "app/option_value.h"

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
    brdf::Preset preset = *brdf::findPreset(options.preset);
    for (const auto& [slot, id] : options.overrides)
        if (!id.empty())
            preset[slot] = brdf::findMethod(slot, id);
    return preset;
}

} // namespace torrance
