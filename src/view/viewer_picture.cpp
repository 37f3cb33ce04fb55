// The picture in the window: how it is drawn, what is drawn over it, and what it is compared with.
#include "view/viewer.h"

#include "core/error.h"
#include "files/image_read.h"
#include "image/quantize.h"
#include "image/srgb.h"
#include "passes/targets.h"
#include "plan/view_scale.h"
#include "study/error_picture.h"
#include "view/screen_place.h"

#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace torrance {

void Viewer::handle(const KeepPicture&)
{
    if (!state.scene)
        return;
    const gpu::DeviceImage& drawn = renderer.frame(state.scene->plan);
    swapchain.waitUntilIdle(); // the old one may still be shown
    compared = {};
    compared.image = makeColorTarget(device, static_cast<int>(drawn.shape.width), static_cast<int>(drawn.shape.height),
                                     "kept picture");
    gpu::Commands commands(device);
    gpu::copyImage(commands, drawn, compared.image);
    commands.submitAndWait();
    compared.curves = shownCurves();
    compared.term = shownTerm;
    state.compared = "the picture that was kept";
}

void Viewer::handle(const OpenPicture& request)
{
    if (!state.scene)
        return;
    ReadImage read = readImage(request.file);
    const bool codes = read.displayReferred;
    const Image color = colorOf(std::move(read), request.file);
    Image opaque(color.width, color.height, 4, 1.0f);
    for (std::size_t i = 0; i < color.texels.size() / 3; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            opaque.texels[4 * i + c] = codes ? srgbDecode(color.texels[3 * i + c]) : color.texels[3 * i + c];
    swapchain.waitUntilIdle();
    compared = {};
    compared.curves = codes ? DisplaySettings{.tone = findToneCurve("none")} : shownCurves();
    compared.image = makeColorTarget(device, color.width, color.height, "picture to compare with");
    const gpu::Buffer texels = gpu::makeBuffer(device, std::as_bytes(std::span(opaque.texels)),
                                               vk::BufferUsageFlagBits::eTransferSrc, "picture to compare with");
    gpu::Commands commands(device);
    gpu::copyToImage(commands, texels, compared.image, 4 * sizeof(float));
    commands.submitAndWait();
    state.compared = request.file;
    if (ivec2(color.width, color.height) != area.size)
        state.notice =
            fmt::format("the file is {} x {} and the picture {} x {}: shown pixel by pixel from the top left",
                        color.width, color.height, area.size.x, area.size.y);
}

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
        swapchain.waitUntilIdle(); // the picture that is drawn into may still be shown
        if (state.changed) {
            applyEdits(state.edits(), state.scene->scene());
            state.changed = false;
            replanOrGoBack();
        }
        state.moved = false;
        const auto begin = std::chrono::steady_clock::now();
        shownCamera = camera();
        renderer.drawFrame(*state.scene->device, shownCamera);
        state.frameMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        hasFrame = true;
        ++state.scenesDrawn;
        shownTerm = {};
        if (const View* view = state.scene->plan.settings.view) {
            const ViewScale scale = scaleOf(*view, readBack(device, renderer.frame(state.scene->plan)));
            shownTerm.factor = scale.factor;
            shownTerm.offset = scale.offset;
        }
        surveyErrors();
    });
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

// Of the picture that is shown; the same until that, or what is selected, is another.
void Viewer::drawOutline()
{
    const Outlined now = {.instance = hasFrame ? state.selectedInstance : -1, .picture = state.scenesDrawn, .line = {}};
    if (now.instance == outlined.instance && now.picture == outlined.picture)
        return;
    swapchain.waitUntilIdle(); // the old one may still be shown
    outlined = now;
    if (now.instance >= 0)
        outlined.line = outline.draw(*state.scene->device, shownCamera, now.instance, area.size);
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
    if (const auto& [picture, part] = outlined.line; picture)
        list.AddImage(const_cast<gpu::DeviceImage*>(picture), first, beyond, {0.0f, 0.0f}, {part.x, part.y}, kSelected);
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

void Viewer::probeAt(const vec2& place)
{
    const ivec2 pixel = glm::clamp(ivec2(place) - area.first, ivec2(0), area.size - 1);
    state.probe = probePixel(device, shaders, state.scene->scene(), shownCamera, state.scene->plan.settings,
                             readBack(device, renderer.frame(state.scene->plan)), pixel);
    if (!state.probe)
        state.notice = "no surface is seen there";
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
