#include "view/panels.h"
#include "view/widgets.h"

#include <imgui.h>

namespace torrance {
namespace {

constexpr int kMostSamples = 64; // that a slider can be set to pixel by pixel; the command line takes more

template <typename Curve>
bool chooseCurve(const PanelContext& context, const char* label, std::span<const Curve> curves, const Curve*& chosen)
{
    std::vector<std::string> names;
    for (const Curve& curve : curves)
        names.emplace_back(curve.id);
    int index = static_cast<int>(chosen - curves.data());
    if (!choose(context, label, names, index))
        return false;
    chosen = &curves[static_cast<std::size_t>(index)];
    return true;
}

void chooseBackground(const PanelContext& context)
{
    ViewerState& state = context.state;
    int kind = static_cast<int>(state.settings.background);
    if (choose(context, "background", {"environment", "colour", "transparent"}, kind)) {
        state.settings.background = static_cast<BackgroundKind>(kind);
        state.changed = true;
    }
    context.mark("picture.background");
    if (state.settings.background == BackgroundKind::color)
        state.changed |= colorLinear("##background", state.settings.backgroundColor);
}

void drawComparison(const PanelContext& context)
{
    ViewerState& state = context.state;
    if (ImGui::Button("Keep it to compare"))
        state.requests.push_back(KeepPicture{});
    context.mark("picture.keep");
    tipOfItem("To compare it with what follows: other methods, other materials.");
    ImGui::SameLine();
    if (ImGui::Button("Compare with a file ..."))
        askForComparison(context);
    context.mark("picture.compare");
    if (state.compared.empty())
        return;
    note("left of the line: " + state.compared);
    ImGui::SliderFloat("line", &state.split, 0.0f, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp);
    context.mark("picture.split");
    if (ImGui::Button("End the comparison"))
        state.compared.clear();
    context.mark("picture.compared");
}

} // namespace

void drawPicturePanel(const PanelContext& context)
{
    ViewerState& state = context.state;
    state.moved |= sliderDouble("exposure", state.write.exposure, -10.0, 10.0, "%+.2f stops");
    context.mark("picture.exposure");
    state.moved |= chooseCurve(context, "tone curve", allToneCurves(), state.write.tone);
    context.mark("picture.tone");
    state.moved |= chooseCurve(context, "transfer", allTransferCurves(), state.write.transfer);
    chooseBackground(context);
    ImGui::SliderInt("samples when saved", &state.fileSamples, 1, kMostSamples, "%d", ImGuiSliderFlags_AlwaysClamp);
    context.mark("picture.samples");
    tipOfItem("Per pixel, of pictures that are saved; the window draws one.");
    if (ImGui::Button("Save the picture ..."))
        askForPicture(context);
    context.mark("picture.save");
    ImGui::SliderInt("turntable frames", &state.kept.turntableFrames, kLeastTurntableFrames, kMostTurntableFrames, "%d",
                     ImGuiSliderFlags_AlwaysClamp);
    context.mark("picture.frames");
    if (ImGui::Button("Save a turntable ..."))
        askForTurntable(context);
    context.mark("picture.turntable");
    drawComparison(context);
    if (ImGui::Button("Copy the command"))
        state.requests.push_back(CopyCommand{});
    context.mark("picture.command");
    tipOfItem("The line that draws this picture: torrance render ...");
}

} // namespace torrance
