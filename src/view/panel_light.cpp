#include "view/edit_scope.h"
#include "view/panels.h"
#include "view/panorama_thumbnails.h"
#include "view/widgets.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>

namespace torrance {
namespace {

constexpr double kHalfPi = kPi / 2.0;

// One of the environments, as a picture with its name below; true where it was clicked.
bool environmentButton(const PanelContext& context, const std::string& name, bool chosen, const ImVec2& size)
{
    ImGui::PushID(name.c_str());
    ImGui::BeginGroup();
    const gpu::DeviceImage* picture = name == "none" ? nullptr : context.panoramas.get(name);
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(chosen ? ImGuiCol_ButtonActive : ImGuiCol_Button));
    const int edge = static_cast<int>(0.2f * context.unit);
    const bool clicked =
        picture ? ImGui::ImageButton(const_cast<gpu::DeviceImage*>(picture), size, {0.0f, 0.0f}, {1.0f, 1.0f}, edge)
                : ImGui::Button("##none", {size.x + 2.0f * float(edge), size.y + 2.0f * float(edge)});
    context.mark("light.environment." + name);
    tipOfItem(name);
    ImGui::PopStyleColor();
    const float width = ImGui::GetItemRectSize().x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const std::string title = std::filesystem::path(name).stem().string();
    ImGui::PushClipRect(corner, {corner.x + width, corner.y + 2.0f * context.unit}, true);
    ImGui::TextUnformatted(title.c_str());
    ImGui::PopClipRect();
    ImGui::EndGroup();
    ImGui::PopID();
    return clicked;
}

void chooseEnvironment(const PanelContext& context, EditScope& edit)
{
    ViewerState& state = context.state;
    EnvironmentChoice& choice = edit.edits.environment;
    constexpr std::size_t kColumns = 3;
    const float width = ImGui::GetContentRegionAvail().x / float(kColumns) - context.unit;
    for (std::size_t i = 0; i < state.environments.size(); ++i) {
        if (i % kColumns != 0)
            ImGui::SameLine(float(i % kColumns) * (width + context.unit) + 0.5f * context.unit);
        const std::string& name = state.environments[i];
        if (environmentButton(context, name, name == choice.name, {width, 0.5f * width}) && name != choice.name) {
            choice.name = name;
            edit.finish();
        }
    }
    if (ImGui::Button("Another panorama ..."))
        askForEnvironment(context);
    context.mark("light.file");
}

void drawEnvironment(const PanelContext& context, EditScope& edit)
{
    EnvironmentChoice& choice = edit.edits.environment;
    chooseEnvironment(context, edit);
    if (choice.name == "none")
        return;
    edit.after(sliderDouble("rotation", choice.rotation, -180.0, 180.0, "%.1f degrees"));
    context.mark("light.rotation");
    tipOfItem("Or drag in the picture with Shift held.");
    edit.after(dragDouble("intensity##environment", choice.intensity, 0.01, 0.0, 1e6));
    context.mark("light.intensity");
    if (context.state.settings.background != BackgroundKind::environment)
        return;
    context.state.changed |= sliderDouble("background blur", context.state.settings.backgroundBlur, 0.0, 1.0);
    context.mark("light.blur");
    tipOfItem("What is seen behind the scene, through a lobe of this roughness; the light stays as it is.");
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
    if (lights.empty())
        return;
    if (ImGui::Checkbox("Turn them about the scene", &state.lampsTurn) && !state.lampsTurn)
        edit.finish(); // where they are now
    context.mark("light.turn");
    sliderDouble("speed", state.kept.lampSpeed, -kMostLampSpeed, kMostLampSpeed, "%.0f degrees a second");
}

} // namespace torrance
