// The parts of the window that are always there: menu, column, status line.
#include "plan/path_plan.h"
#include "view/file_browser.h"
#include "view/panels.h"
#include "view/widgets.h"

#include <GLFW/glfw3.h>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>

namespace torrance {
namespace {

constexpr float kColumnUnits = 25.0f; // lines of text: wide enough for a slider and its name

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;

void drawFileMenu(const PanelContext& context)
{
    ViewerState& state = context.state;
    if (ImGui::MenuItem("Open ...", "Ctrl+O"))
        askForScene(context);
    context.mark("menu.open");
    if (ImGui::BeginMenu("Recent", !state.recent.empty())) {
        for (const std::string& file : state.recent)
            if (ImGui::MenuItem(file.c_str()))
                state.requests.push_back(OpenScene{file});
        ImGui::EndMenu();
    }
    if (ImGui::MenuItem("Read again", "F5", false, state.scene != nullptr))
        state.requests.push_back(OpenScene{state.scene->input, true});
    ImGui::Separator();
    if (ImGui::MenuItem("Save the scene ...", "Ctrl+S", false, state.scene != nullptr))
        askForSave(context);
    context.mark("menu.save");
    if (ImGui::MenuItem("Save the picture ...", "Ctrl+P", false, state.scene != nullptr))
        askForPicture(context);
    context.mark("menu.picture");
    if (ImGui::MenuItem("Copy the command", "Ctrl+C", false, state.scene != nullptr))
        state.requests.push_back(CopyCommand{});
    ImGui::Separator();
    if (ImGui::MenuItem("Quit", "Ctrl+Q"))
        state.requests.push_back(Quit{});
}

void drawEditMenu(const PanelContext& context)
{
    ViewerState& state = context.state;
    if (ImGui::MenuItem("Undo", "Ctrl+Z", false, state.history && state.history->canUndo())) {
        state.history->undo();
        state.changed = true;
    }
    context.mark("menu.undo");
    if (ImGui::MenuItem("Redo", "Ctrl+Shift+Z", false, state.history && state.history->canRedo())) {
        state.history->redo();
        state.changed = true;
    }
    context.mark("menu.redo");
}

void drawViewMenu(const PanelContext& context)
{
    ViewerState& state = context.state;
    const auto look = [&](const char* name, const char* key, double theta, double phi) {
        if (ImGui::MenuItem(name, key)) {
            state.view = FittedView{theta, phi};
            state.moved = true;
        }
    };
    const FittedView whole = wholeSceneFrom(state.view);
    look("Frame all", "F", whole.theta, whole.phi);
    look("Front", "1", 0.0, 90.0);
    look("Right", "3", 90.0, 90.0);
    look("Top", "7", 0.0, 0.0);
    look("Back", "Ctrl+1", -180.0, 90.0);
    look("Left", "Ctrl+3", -90.0, 90.0);
    look("Bottom", "Ctrl+7", 0.0, 180.0);
    ImGui::Separator();
    ImGui::MenuItem("Panels", "Tab", &state.kept.showPanels);
    ImGui::MenuItem("Plan", nullptr, &state.showPlan);
}

void section(const PanelContext& context, const char* title, bool isOpen, void (*draw)(const PanelContext&))
{
    const bool open = ImGui::CollapsingHeader(title, isOpen ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
    context.mark(std::string("section.") + title);
    if (!open)
        return;
    ImGui::PushID(title);
    ImGui::PushItemWidth(context.unit * 11.0f);
    draw(context);
    ImGui::PopItemWidth();
    ImGui::PopID();
}

} // namespace

void PanelContext::mark(const std::string& name) const
{
    const ImVec2 first = ImGui::GetItemRectMin(), beyond = ImGui::GetItemRectMax();
    places[name] = {first.x, first.y, beyond.x, beyond.y};
}

void PanelContext::markWindow(const std::string& name) const
{
    const ImVec2 first = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    places[name] = {first.x, first.y, first.x + size.x, first.y + size.y};
}

float drawMenu(const PanelContext& context)
{
    if (!ImGui::BeginMainMenuBar())
        return 0.0f;
    const auto menu = [&](const char* title, void (*draw)(const PanelContext&)) {
        const bool open = ImGui::BeginMenu(title);
        context.mark(std::string("menu.") + title);
        if (open) {
            draw(context);
            ImGui::EndMenu();
        }
    };
    menu("File", drawFileMenu);
    menu("Edit", drawEditMenu);
    menu("View", drawViewMenu);
    if (ImGui::MenuItem("Help"))
        context.state.showHelp = true;
    context.mark("menu.Help");
    const float height = ImGui::GetWindowSize().y;
    ImGui::EndMainMenuBar();
    return height;
}

float drawStatus(const PanelContext& context)
{
    const ViewerState& state = context.state;
    const ImVec2 size = ImGui::GetMainViewport()->Size;
    const float height = context.unit * 1.6f;
    ImGui::SetNextWindowPos({0.0f, size.y - height});
    ImGui::SetNextWindowSize({size.x, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.unit * 0.5f, context.unit * 0.25f});
    ImGui::Begin("status", nullptr, kFixed | ImGuiWindowFlags_NoScrollbar);
    std::string text = state.deviceName;
    if (state.scene) {
        const ShadingPlan& plan = state.scene->plan;
        text = fmt::format("{:.0f} ms a picture   {} x {}   {} triangles   {} batches, {}   {}", state.frameMs,
                           plan.settings.width, plan.settings.height, state.scene->loaded.facts.triangles,
                           plan.batches.size() + plan.blended.size(), nameOf(plan.path), state.deviceName);
    }
    ImGui::TextUnformatted(text.c_str());
    if (!state.notice.empty()) {
        ImGui::SameLine(0.0f, context.unit * 2.0f);
        ImGui::TextColored({0.6f, 0.9f, 0.6f, 1.0f}, "%s", state.notice.c_str());
    }
    ImGui::End();
    ImGui::PopStyleVar();
    return height;
}

float drawColumn(const PanelContext& context, float top, float bottom)
{
    const ImVec2 size = ImGui::GetMainViewport()->Size;
    const float width = context.unit * kColumnUnits;
    if (!context.state.kept.showPanels || size.x < 1.5f * width || bottom - top < context.unit * 8.0f)
        return 0.0f; // in a window this small the picture has all of it
    ImGui::SetNextWindowPos({size.x - width, top});
    ImGui::SetNextWindowSize({width, bottom - top});
    ImGui::Begin("panels", nullptr, kFixed);
    if (!context.state.scene)
        note("Nothing is open. Drop a file on the window, or take File > Open.");
    else {
        section(context, "Scene", true, drawScenePanel);
        section(context, "Material", true, drawMaterialPanel);
        section(context, "Light", false, drawLightPanel);
        section(context, "Methods", false, drawMethodPanel);
        section(context, "Picture", false, drawPicturePanel);
    }
    ImGui::End();
    return width;
}

} // namespace torrance
