#include "view/edit_scope.h"
#include "view/panels.h"
#include "view/widgets.h"

#include <fmt/format.h>
#include <imgui.h>

namespace torrance {
namespace {

std::string nameOf(const Scene& scene, const Instance& instance)
{
    const std::string& name = scene.primitives[static_cast<std::size_t>(instance.primitive)].name;
    return name.empty() ? fmt::format("object {}", instance.object) : name;
}

void drawTree(const PanelContext& context)
{
    ViewerState& state = context.state;
    const Scene& scene = state.scene->scene();
    ImGui::BeginChild("objects", {0.0f, context.unit * 8.0f}, true);
    ImGuiListClipper clipper; // a scene may have a hundred thousand instances
    clipper.Begin(static_cast<int>(scene.instances.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const Instance& instance = scene.instances[static_cast<std::size_t>(i)];
            ImGui::PushID(i);
            if (ImGui::Selectable(nameOf(scene, instance).c_str(), i == state.selectedInstance)) {
                state.selectedInstance = i;
                state.selectedMaterial = scene.primitives[static_cast<std::size_t>(instance.primitive)].material;
            }
            ImGui::PopID();
            context.mark(fmt::format("object.{}", i));
        }
    ImGui::EndChild();
}

void drawCameras(const PanelContext& context)
{
    ViewerState& state = context.state;
    const Scene& scene = state.scene->scene();
    if (!scene.cameras.empty()) {
        std::vector<std::string> names = {"free"};
        for (std::size_t i = 0; i < scene.cameras.size(); ++i)
            names.push_back(scene.cameras[i].name.empty() ? fmt::format("camera {}", i) : scene.cameras[i].name);
        const auto* file = std::get_if<FileView>(&state.view);
        int chosen = file ? file->index + 1 : 0;
        if (choose(context, "camera", names, chosen)) {
            state.view = chosen == 0 ? ViewPoint(FittedView{}) : ViewPoint(FileView{chosen - 1});
            state.moved = true;
        }
        context.mark("scene.camera");
    }
    if (auto* pose = std::get_if<OrbitPose>(&state.view)) {
        state.moved |= sliderDouble("field of view", pose->verticalFov, 1.0, 150.0, "%.1f degrees");
        state.moved |= dragPoint("target", pose->target, 0.01 * pose->radius);
    } else
        note("Drag in the picture to look around.");
}

} // namespace

void drawScenePanel(const PanelContext& context)
{
    const SceneOnDevice& scene = *context.state.scene;
    const SceneFacts& facts = scene.loaded.facts;
    note(scene.input);
    ImGui::Text("%zu triangles, %zu objects, %zu materials", facts.triangles, scene.scene().instances.size(),
                scene.scene().materials.size());
    if (!scene.bounds.empty) {
        const dvec3 size = scene.bounds.max - scene.bounds.min;
        ImGui::Text("size %.3g x %.3g x %.3g", size.x, size.y, size.z);
    }
    for (const std::string& warning : scene.loaded.warnings)
        note(warning);
    drawTree(context);
    drawCameras(context);
}

} // namespace torrance
