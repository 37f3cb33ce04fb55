// A tolerance for the picture, and what was found for it.
#include "view/panels.h"
#include "view/widgets.h"

#include <fmt/format.h>
#include <imgui.h>

namespace torrance {

void drawTolerancePanel(const PanelContext& context)
{
    ViewerState& state = context.state;
    double percent = 100.0 * state.kept.tolerance;
    if (sliderDouble("tolerance", percent, 100.0 * kLeastTolerance, 100.0 * kMostTolerance, "%.2g %% of the light",
                     ImGuiSliderFlags_Logarithmic))
        state.kept.tolerance = percent / 100.0;
    context.mark("method.tolerance");
    tipOfItem("The mean shading error that the picture may have, as --tolerance has it.");
    if (state.findsMethods) {
        if (ImGui::Button("Stop"))
            state.requests.push_back(StopFinding{});
        context.mark("method.stop");
        ImGui::SameLine();
        ImGui::TextUnformatted(state.pictureTried == 0
                                   ? "finding out what is exact"
                                   : fmt::format("picture {} is compared", state.pictureTried).c_str());
        return;
    }
    if (ImGui::Button("Find the cheapest methods within it"))
        state.requests.push_back(FindMethods{{.mean = state.kept.tolerance, .percentile99 = {}}});
    context.mark("method.find");
    tipOfItem("Draws, compares some pixels with exact light, and takes nearer methods until the picture is within.");
    if (!state.found)
        return;
    const ToleranceResult& found = *state.found;
    if (state.scenesDrawn > state.foundAt)
        note("What was found for an earlier picture:");
    ImGui::Text("%.2g %%: %s", 100.0 * found.plan.tolerance.mean,
                found.holds ? "the picture is within it" : "out of reach");
    if (!found.obstacle.empty())
        note(found.obstacle);
    for (const std::string& line : toleranceLines(found))
        note(line);
}

} // namespace torrance
