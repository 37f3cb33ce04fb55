#include "view/file_browser.h"
#include "view/panels.h"
#include "view/widgets.h"

#include <algorithm>
#include <imgui.h>

namespace torrance {
namespace {

constexpr ImGuiWindowFlags kDialog = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;

void placeInMiddle(float width)
{
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(viewport.GetCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(width, viewport.Size.x * 0.9f), 0.0f}, ImGuiCond_Appearing);
}

void drawError(const PanelContext& context)
{
    ViewerState& state = context.state;
    if (state.error.empty())
        return;
    placeInMiddle(context.unit * 36.0f);
    bool open = true;
    ImGui::Begin("That did not work", &open, kDialog);
    context.markWindow("dialog.error");
    ImGui::TextWrapped("%s", state.error.c_str());
    ImGui::Spacing();
    if (ImGui::Button("Close"))
        open = false;
    context.mark("error.close");
    ImGui::End();
    if (!open)
        state.error.clear();
}

void drawOpening(const PanelContext& context)
{
    ViewerState& state = context.state;
    if (state.opening.empty())
        return;
    static constexpr const char* kParts[] = {"reading", "planning", "uploading"};
    placeInMiddle(context.unit * 30.0f);
    ImGui::Begin("Opening", nullptr, kDialog);
    ImGui::TextWrapped("%s", state.opening.c_str());
    ImGui::ProgressBar(static_cast<float>(state.openingPart) / float(int(kOpeningParts)), {-1.0f, 0.0f},
                       kParts[std::clamp(state.openingPart, 0, kOpeningParts - 1)]);
    if (ImGui::Button("Cancel"))
        state.cancelOpening = true;
    context.mark("opening.cancel");
    ImGui::End();
}

void drawUnsavedQuestion(const PanelContext& context)
{
    ViewerState& state = context.state;
    if (!state.unsaved)
        return;
    placeInMiddle(context.unit * 30.0f);
    ImGui::Begin("Unsaved changes", nullptr, kDialog);
    context.markWindow("dialog.close");
    ImGui::TextWrapped("Materials of %s were changed, and not saved.", state.scene->input.c_str());
    ImGui::Spacing();
    const bool saves = ImGui::Button("Save ...");
    context.mark("close.save");
    ImGui::SameLine();
    const bool discards = ImGui::Button("Throw them away");
    context.mark("close.discard");
    ImGui::SameLine();
    const bool stays = ImGui::Button("Cancel");
    context.mark("close.stay");
    ImGui::End();
    if (saves)
        askForSaveBefore(context, *state.unsaved);
    if (discards)
        state.requests.push_back(*state.unsaved);
    if (saves || discards || stays)
        state.unsaved.reset();
}

void drawHelp(const PanelContext& context)
{
    if (!context.state.showHelp)
        return;
    static constexpr const char* kKeys[][2] = {
        {"drag", "turn about the target (left button)"},
        {"right drag, Ctrl+drag", "move across"},
        {"wheel, + and -", "nearer and farther"},
        {"wheel aside", "turn about the target"},
        {"Shift+wheel", "move across, both ways"},
        {"arrows", "turn by 5 degrees"},
        {"W A S D", "fly"},
        {"Shift+drag", "turn the environment"},
        {"drag a lamp's mark", "move the lamp"},
        {"click", "select an object and its material"},
        {"double click", "look at what is there"},
        {"Escape", "close what is open; select no object"},
        {"F, Shift+F", "frame all, the selected object"},
        {"1 3 7, with Ctrl", "front, right, top; back, left, bottom"},
        {"C", "next camera of the file"},
        {"Ctrl+O, F5", "open, read again"},
        {"Ctrl+S", "save the scene"},
        {"Ctrl+P", "save the picture"},
        {"Ctrl+C", "copy the command that draws this picture"},
        {"Ctrl+Z, Ctrl+Shift+Z", "undo, redo"},
        {"R", "read the shaders again"},
        {"Tab", "panels on and off"},
        {"?", "this list"},
    };
    placeInMiddle(context.unit * 36.0f);
    ImGui::Begin("Keys and mouse", &context.state.showHelp, kDialog);
    context.markWindow("dialog.help");
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const auto& [key, meaning] : kKeys) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(key);
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(meaning);
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

void drawPlan(const PanelContext& context)
{
    if (!context.state.showPlan || !context.state.scene)
        return;
    ImGui::SetNextWindowSize({context.unit * 50.0f, context.unit * 30.0f}, ImGuiCond_Appearing);
    ImGui::SetNextWindowPos({context.unit * 2.0f, context.unit * 3.0f}, ImGuiCond_Appearing);
    ImGui::Begin("Plan", &context.state.showPlan, kDialog);
    context.markWindow("dialog.plan");
    const std::string text = explain(context.state.scene->plan);
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::End();
}

} // namespace

void drawDialogs(const PanelContext& context)
{
    context.browser.draw(context);
    drawPlan(context);
    drawHelp(context);
    drawOpening(context);
    drawUnsavedQuestion(context);
    drawError(context);
}

} // namespace torrance
