#include "brdf/selection.h"

#include "brdf/brdf.h"

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
    text += selected(*preset.model); // it calls the others
    return text;
}

} // namespace torrance::brdf
