#include "plan/path_plan.h"
#include "plan/shading_plan.h"

#include <set>

namespace torrance {
namespace {

std::string counted(std::size_t n, const char* one, const char* many)
{
    return std::to_string(n) + " " + (n == 1 ? one : many);
}

void addMethods(std::string& text, const brdf::Preset& methods)
{
    text += "methods\n";
    for (const brdf::Slot slot : brdf::allSlots())
        if (const brdf::Method* method = methods[slot])
            text.append("  ").append(brdf::slotName(slot)).append(": ").append(method->id).append("\n");
    for (const brdf::ModelOption& option : brdf::allModelOptions()) {
        if (option.model != methods.model->id)
            continue;
        text.append("  ").append(option.isQuirk() ? "quirk " : "parameter ").append(option.id).append(": ");
        text += option.isQuirk()
                    ? methods.options.*std::get<bool brdf::ModelOptions::*>(option.member) ? "on" : "off"
                    : std::to_string(methods.options.*std::get<double brdf::ModelOptions::*>(option.member));
        text += "\n";
    }
}

void addDrawn(std::string& text, const ShadingPlan& plan)
{
    std::set<std::string> pipelines;
    std::size_t draws = 0;
    for (const auto* list : {&plan.batches, &plan.blended})
        for (const Batch& batch : *list) {
            pipelines.insert(batch.key.name());
            draws += batch.draws.size();
        }
    text += "drawn\n";
    text += "  " + counted(plan.instances.size(), "instance", "instances") + " in " + counted(draws, "draw", "draws") +
            ", " + counted(plan.batches.size() + plan.blended.size(), "batch", "batches") + "\n";
    text += "  " + counted(static_cast<std::size_t>(plan.lightCounts[0]), "directional light", "directional lights") +
            ", " + counted(static_cast<std::size_t>(plan.lightCounts[1]), "point light", "point lights") + ", " +
            counted(static_cast<std::size_t>(plan.lightCounts[2]), "spot light", "spot lights") + "\n";
    for (std::size_t i = 0; i < plan.lights.size(); ++i) // as --view-light counts them
        text += "  light " + std::to_string(i) + ": " +
                (plan.lights[i].name.empty() ? "unnamed" : plan.lights[i].name) + "\n";
    text += std::string("  environment: ") + (plan.environmentLight ? "lights the scene" : "lights nothing") +
            (!plan.panorama                       ? ", is not seen"
             : plan.settings.backgroundBlur > 0.0 ? ", is seen behind it, blurred"
                                                  : ", is seen behind it") +
            "\n";
    text += std::string("  path: ") + nameOf(plan.path);
    if (plan.path == RenderPath::deferred)
        text += ", " + counted(plan.lightingClasses.size(), "lighting pass", "lighting passes");
    if (plan.path == RenderPath::attributes)
        text += ", " + counted(plan.classes.size(), "class", "classes") + " of surfaces shaded once a pixel";
    text += "\n";
    text += "pipelines\n";
    for (const std::string& name : pipelines)
        text += "  " + name + "\n";
}

} // namespace

std::string explain(const ShadingPlan& plan)
{
    std::string text;
    addMethods(text, plan.settings.methods);
    for (const auto& [material, own] : plan.settings.ofMaterials)
        text += "  of material " + materialMethodsText(material, own) + "\n";
    addDrawn(text, plan);
    text += "decided\n";
    for (const Remark& remark : plan.remarks)
        text += "  " + remark.subject + ": " + remark.choice + " (" + remark.reason + ")\n";
    return text;
}

} // namespace torrance
