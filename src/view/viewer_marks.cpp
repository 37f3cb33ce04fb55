// What is drawn over the picture in the window.
#include "view/viewer.h"

#include "view/screen_place.h"

#include <cmath>
#include <imgui.h>

namespace torrance {

// Of the picture that is shown; the same until that, or what is selected, is another.
void Viewer::drawOutline()
{
    const Outlined now = {.instance = hasFrame ? state.selectedInstance : -1, .picture = state.scenesDrawn};
    if (now.instance == outlined.instance && now.picture == outlined.picture)
        return;
    swapchain.waitUntilIdle(); // the old one may still be shown
    outlined = now;
    if (now.instance >= 0)
        outlined.line = &outline.draw(*state.scene->device, shownCamera, now.instance, area.size);
}

void Viewer::drawMarks()
{
    if (!state.scene)
        return;
    drawOutline();
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    const auto inWindow = [&](const dvec2& pixel) {
        return ImVec2((float(pixel.x) + float(area.first.x)) / scale.x,
                      (float(pixel.y) + float(area.first.y)) / scale.y);
    };
    constexpr ImU32 kSelected = IM_COL32(255, 170, 40, 255), kProbed = IM_COL32(80, 230, 255, 255),
                    kLine = IM_COL32(255, 255, 255, 255), kLamp = IM_COL32(255, 230, 90, 255);
    const ImVec2 first = inWindow(dvec2(0.0)), beyond = inWindow(dvec2(area.size));
    list.PushClipRect(first, beyond);
    if (outlined.line) {
        const gpu::DeviceImage& line = *outlined.line;
        const ImVec2 part(float(line.shape.width) / float(line.inMemory.width),
                          float(line.shape.height) / float(line.inMemory.height));
        list.AddImage(const_cast<gpu::DeviceImage*>(&line), first, beyond, {0.0f, 0.0f}, part, kSelected);
    }
    for (const Light& light : state.edits().lights)
        if (const auto pixel = light.kind == Light::Kind::directional
                                   ? std::nullopt
                                   : pixelOfPoint(light.position, shownCamera, area.size))
        {
            list.AddCircleFilled(inWindow(*pixel), kLampRadius, kLamp);
            list.AddCircle(inWindow(*pixel), kLampRadius, IM_COL32_BLACK);
        }
    if (!state.compared.empty()) {
        const double x = std::lround(state.split * float(area.size.x));
        list.AddLine(inWindow({x, 0.0}), inWindow({x, area.size.y}), kLine);
    }
    if (state.probe)
        list.AddCircle(inWindow(dvec2(state.probe->pixel) + 0.5), 6.0f, kProbed, 0, 1.5f);
    list.PopClipRect();
}

} // namespace torrance
