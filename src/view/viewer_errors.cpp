// How wrong the picture in the window is: errors of all its pixels, terms of one.
#include "view/viewer.h"

#include "core/error.h"
#include "image/quantize.h"
#include "passes/targets.h"
#include "study/error_picture.h"

#include <cmath>
#include <imgui.h>

namespace torrance {

void Viewer::surveyErrors()
{
    survey.stop();
    state.errors = {};
    if (state.showsErrors)
        survey.start(state.scene->scene(), shownCamera, state.scene->plan.settings,
                     readBack(device, renderer.frame(state.scene->plan)));
}

void Viewer::showErrors()
{
    if (!state.showsErrors)
        return;
    if (survey.takeNews(state.errors)) {
        if (!state.errors.problem.empty())
            throw Error(ExitCode::usage, state.errors.problem);
        const Image& errors = state.errors.errors;
        const Image colors = errorPicture(errors);
        std::vector<std::byte> codes;
        for (std::size_t i = 0; i < errors.texels.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c)
                codes.push_back(static_cast<std::byte>(quantized(colors.texels[3 * i + c], 255)));
            codes.push_back(std::isnan(errors.texels[i]) ? std::byte{0} : std::byte{255}); // no surface: as it is
        }
        swapchain.waitUntilIdle(); // the old one may still be shown
        errorImage = uploadPanelPicture(device, errors.width, errors.height, codes, "errors");
    }
    if (state.errors.pixels == 0)
        return;
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    const vec2 first = vec2(area.first) / vec2(scale.x, scale.y), size = vec2(area.size) / vec2(scale.x, scale.y);
    ImGui::GetBackgroundDrawList()->AddImage(&errorImage, {first.x, first.y}, {first.x + size.x, first.y + size.y});
}

void Viewer::probeAt(const vec2& place)
{
    const ivec2 pixel = glm::clamp(ivec2(place) - area.first, ivec2(0), area.size - 1);
    state.probe = probePixel(device, shaders, state.scene->scene(), shownCamera, state.scene->plan.settings,
                             readBack(device, renderer.frame(state.scene->plan)), pixel);
    if (!state.probe)
        state.notice = "no surface is seen there";
}

} // namespace torrance
