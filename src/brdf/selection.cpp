#include "brdf/selection.h"

#include "brdf/brdf.h"

#include <algorithm>
#include <fmt/format.h>

namespace torrance::brdf {

std::string glslPath(const Method& method)
{
    if (!method.file.empty())
        return std::string(method.file);
    return "brdf/" + std::string(slotName(method.slot)) + "/" + std::string(method.id) + ".glsl";
}

std::string functionName(const Method& method)
{
    return std::string(slotPrefix(method.slot)) + "_" + std::string(method.id);
}

namespace {

std::string selected(const Method& method)
{
    return "#include \"" + glslPath(method) + "\"\n#define SELECTED_" + std::string(slotName(method.slot)) + " " +
           functionName(method) + "\n";
}

std::string glslName(const ModelOption& option)
{
    std::string name = (option.isQuirk() ? "QUIRK_" : "PARAMETER_") + std::string(option.id);
    std::ranges::replace(name, '-', '_');
    return name;
}

// The options of the preset's model as constants, so that what is off costs nothing.
std::string modelConstants(const Preset& preset)
{
    std::string text;
    for (const ModelOption& option : allModelOptions()) {
        if (option.model != preset.model->id)
            continue;
        if (const auto* quirk = std::get_if<bool ModelOptions::*>(&option.member))
            text += fmt::format("const bool {} = {};\n", glslName(option), preset.options.*(*quirk));
        else
            text += fmt::format("const float {} = {:.9e};\n", glslName(option),
                                preset.options.*std::get<double ModelOptions::*>(option.member));
    }
    return text;
}

} // namespace

std::string selectedGlsl(const Preset& preset)
{
    requireWholeBrdf(preset);
    std::string text;
    for (const Slot slot : allSlots()) {
        const Method* method = preset[slot];
        if (method && hasShadingFunction(slot) && slot != Slot::model)
            text += selected(*method);
    }
    text += modelConstants(preset) + selected(*preset.model); // it calls the others
    return text;
}

} // namespace torrance::brdf
