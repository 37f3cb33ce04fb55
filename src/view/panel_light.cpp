#include "view/edit_scope.h"
#include "view/panels.h"
#include "view/widgets.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace torrance {
namespace {

constexpr double kHalfPi = kPi / 2.0;

void drawEnvironment(const PanelContext& context, EditScope& edit)
{
    ViewerState& state = context.state;
    EnvironmentChoice& choice = edit.edits.environment;
    const auto found = std::ranges::find(state.environments, choice.name);
    int chosen = static_cast<int>(found - state.environments.begin());
    if (choose(context, "environment", state.environments, chosen)) {
        choice.name = state.environments[static_cast<std::size_t>(chosen)];
        edit.finish();
    }
    context.mark("light.environment");
    if (choice.name == "none")
        return;
    edit.after(sliderDouble("rotation", choice.rotation, -180.0, 180.0, "%.1f degrees"));
    context.mark("light.rotation");
    tipOfItem("Or drag in the picture with Shift held.");
    edit.after(dragDouble("intensity##environment", choice.intensity, 0.01, 0.0, 1e6));
    context.mark("light.intensity");
}

void drawLight(const PanelContext& context, EditScope& edit, Light& light, double size)
{
    int kind = static_cast<int>(light.kind);
    if (choose(context, "kind", {"directional", "point", "spot"}, kind)) {
        light.kind = static_cast<Light::Kind>(kind);
        edit.finish();
    }
    edit.after(colorLinear("colour", light.color));
    const bool directional = light.kind == Light::Kind::directional;
    edit.after(dragDouble("intensity", light.intensity, 0.02, 0.0, 1e9, directional ? "%.3f lux" : "%.3f candela"));
    if (!directional) {
        edit.after(dragPoint("position", light.position, 0.01 * size));
        edit.after(dragDouble("radius", light.radius, 0.002 * size, 0.0, size));
    }
    if (light.kind == Light::Kind::point)
        return;
    dvec3 direction = light.direction;
    const bool turned = dragPoint("direction", direction, 0.01);
    if (turned && glm::length(direction) > 0.0)
        light.direction = glm::normalize(direction);
    edit.after(turned);
    if (light.kind == Light::Kind::spot) {
        edit.after(sliderDouble("outer cone", light.outerConeAngle, 0.01, kHalfPi, "%.2f rad"));
        light.innerConeAngle = std::min(light.innerConeAngle, light.outerConeAngle);
        edit.after(sliderDouble("inner cone", light.innerConeAngle, 0.0, light.outerConeAngle, "%.2f rad"));
    }
}

} // namespace

void drawLightPanel(const PanelContext& context)
{
    ViewerState& state = context.state;
    EditScope edit(state);
    drawEnvironment(context, edit);
    const Bounds& bounds = state.scene->bounds;
    const double size = bounds.empty ? 1.0 : glm::length(bounds.max - bounds.min);
    std::vector<Light>& lights = edit.edits.lights;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const std::string name = lights[i].name.empty() ? fmt::format("light {}", i) : lights[i].name;
        if (ImGui::TreeNode("light", "%s", name.c_str())) {
            drawLight(context, edit, lights[i], size);
            if (ImGui::SmallButton("Take it away")) {
                lights.erase(lights.begin() + static_cast<std::ptrdiff_t>(i));
                edit.finish();
                ImGui::TreePop();
                ImGui::PopID();
                break;
            }
            ImGui::TreePop();
        }
        ImGui::PopID();
    }
    if (ImGui::Button("Add a lamp")) {
        const dvec3 center = bounds.empty ? dvec3(0.0) : 0.5 * (bounds.min + bounds.max);
        // From the upper right in front: as bright on the scene as three lux.
        Light lamp = {.name = "lamp", .kind = Light::Kind::point, .intensity = 3.0 * size * size};
        lamp.position = center + size * glm::normalize(dvec3(1.0, 1.0, 1.0));
        lights.push_back(lamp);
        edit.finish();
    }
    context.mark("light.add");
}

} // namespace torrance
