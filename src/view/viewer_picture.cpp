// The picture in the window: how it is drawn and shown.
#include "view/viewer.h"

#include "core/error.h"
#include "passes/targets.h"
#include "plan/view_scale.h"

#include <chrono>
#include <cmath>
#include <imgui.h>

namespace torrance {

void Viewer::handle(const ReloadShaders&)
{
    Renderer::Pipelines old = renderer.exchangePipelines({});
    try {
        if (state.scene)
            renderer.drawFrame(*state.scene->device, camera());
        state.notice = "shaders read again";
        state.moved = true;
    } catch (...) {
        renderer.exchangePipelines(std::move(old)); // the last good ones
        throw;
    }
}

void Viewer::drawScene()
{
    if (!state.scene || !(state.changed || state.moved))
        return;
    attempt([&] {
        survey.stop();
        state.probe.reset();
        takeEdits();
        state.moved = false;
        shownCamera = camera();
        drawFrame();
        shownTerm = {};
        if (const View* view = state.scene->plan.settings.view) {
            const ViewScale scale = scaleOf(*view, readBack(device, renderer.frame(state.scene->plan)));
            shownTerm.factor = scale.factor;
            shownTerm.offset = scale.offset;
        }
        surveyErrors();
    });
}

// The scene as the panels have it, planned.
void Viewer::takeEdits()
{
    if (!state.changed)
        return;
    swapchain.waitUntilIdle(); // what the old plan owns may still be shown
    applyEdits(state.edits(), state.scene->scene());
    state.changed = false;
    replanOrGoBack();
}

// Of the plan as it is, from shownCamera.
void Viewer::drawFrame()
{
    swapchain.waitUntilIdle(); // the picture that is drawn into may still be shown
    const auto begin = std::chrono::steady_clock::now();
    renderer.drawFrame(*state.scene->device, shownCamera);
    state.frameMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    hasFrame = true;
    ++state.scenesDrawn;
}

// Methods that cannot be combined are refused: then those that were chosen last stay.
void Viewer::replanOrGoBack()
{
    try {
        replan(renderer, *state.scene, effectiveSettings());
    } catch (const Error&) {
        const int width = state.settings.width, height = state.settings.height;
        std::swap(state.settings, plannedSettings);
        state.settings.width = width;
        state.settings.height = height;
        replan(renderer, *state.scene, effectiveSettings());
        plannedSettings = state.settings;
        state.moved = true;
        throw;
    }
    plannedSettings = state.settings;
}

// Of the picture that is drawn: a term has neither exposure nor tone curve.
WriteSettings Viewer::curves() const
{
    WriteSettings curves = state.write;
    if (state.scene->plan.settings.view) {
        curves.exposure = 0.0;
        curves.tone = findToneCurve("none");
    }
    return curves;
}

DisplaySettings Viewer::shownCurves() const
{
    const WriteSettings shown = curves();
    return {.exposure = shown.exposure, .tone = shown.tone, .transfer = shown.transfer};
}

void Viewer::showPicture()
{
    ImDrawData& panels = *ImGui::GetDrawData();
    const gpu::DeviceImage* const targets[] = {&windowPicture};
    const auto record = [&](gpu::Commands& commands) {
        std::vector<gpu::Buffer> buffers;
        panelRenderer.use(commands, panels);
        const bool shows = state.scene && hasFrame;
        if (shows)
            commands.use({gpu::use(renderer.frame(state.scene->plan), gpu::Access::sampled)});
        if (shows && !state.compared.empty())
            commands.use({gpu::use(compared.image, gpu::Access::sampled)});
        beginRendering(commands, targets, nullptr, vec4(0.2f, 0.2f, 0.21f, 1.0f), LoadTarget::clear);
        if (shows) {
            const ShadingPlan& plan = state.scene->plan;
            DisplayPlace place = shownTerm;
            place.origin = area.first;
            place.size = glm::min(area.size, ivec2(plan.settings.width, plan.settings.height));
            if (!state.compared.empty()) {
                place.skip = static_cast<int>(std::lround(state.split * float(place.size.x)));
                DisplayPlace other = compared.term;
                other.origin = place.origin;
                const ivec2 its(compared.image.shape.width, compared.image.shape.height);
                other.size = glm::min(ivec2(place.skip, place.size.y), its);
                if (other.size.x > 0)
                    buffers.push_back(display.draw(commands, compared.image, other, compared.curves));
            }
            buffers.push_back(display.draw(commands, renderer.frame(plan), place, shownCurves()));
        }
        panelRenderer.draw(commands, panels, buffers);
        commands.buffer.endRendering();
        return buffers;
    };
    if (!swapchain.show(windowPicture, record))
        settling = kSettlingPictures; // the window has another size
}

} // namespace torrance
