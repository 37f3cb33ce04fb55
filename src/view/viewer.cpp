#include "view/viewer.h"

#include "core/error.h"
#include "gpu/guard.h"
#include "passes/targets.h"
#include "plan/pixel_sampling_plan.h"
#include "scene/default_view.h"
#include "view/viewer_report.h"

#include <algorithm>
#include <filesystem>
#include <imgui.h>
#include <new>

namespace torrance {
namespace {

constexpr double kProgressSeconds = 0.1; // between two looks at work in the background
constexpr double kWatchSeconds = 0.5;    // between two looks at files
constexpr double kCursorSeconds = 0.4;   // between two pictures while a text is typed

gpu::DeviceOptions deviceOptions(const ViewerHost& host, const Window& window)
{
    return {.choice = host.deviceChoice, .validation = host.validation, .windowExtensions = window.extensions()};
}

vk::Extent2D extentOf(const ivec2& size)
{
    return {static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y)};
}

ivec2 firstSize(const ViewerHost& host, const KeptSettings& kept)
{
    return host.choosesSize || kept.windowSize == ivec2(0) ? host.windowSize : kept.windowSize;
}

} // namespace

void Viewer::attempt(const std::function<void()>& work)
{
    try {
        work();
    } catch (const Error& error) {
        if (error.exitCode == ExitCode::deviceFailure)
            throw; // nothing that is shown can be trusted any more
        state.error = error.what();
    } catch (const std::bad_alloc&) {
        state.error = "not enough memory; take a smaller scene or a smaller picture";
    }
}

Viewer::Viewer(ViewerHost h)
    : host(std::move(h)), kept(loadSettings(host.configFolder)), window("Torrance", firstSize(host, kept)),
      panelLibrary(window), device(deviceOptions(host, window)), shaders(host.shaderFolder, host.cacheFolder),
      renderer(device, shaders, host.cacheFolder), swapchain(device, window.makeSurface(device)),
      display(device, shaders, swapchain.format()), outline(device, shaders),
      panelRenderer(device, shaders, swapchain.format()), thumbnails(device),
      panoramas(
          device, [this](const std::string& name) { return this->host.loadEnvironment({.name = name}); }, Window::wake),
      survey(Window::wake), search(Window::wake), sceneTask(Window::wake), environmentTask(Window::wake),
      saveTask(Window::wake)
{
    state.settings = host.settings;
    state.fileSamples = host.settings.samples;
    if (!shadesOncePerPixel(state.settings))
        state.settings.samples = 1;
    state.write = host.write;
    state.deviceName = device.description.name;
    state.recent = loadRecent(host.configFolder);
    state.kept = kept;
    state.environments = host.environments;
    if (host.watch)
        watchedShaders.emplace(host.shaderFolder);
    openFirst();
}

Viewer::~Viewer()
{
    swapchain.waitAtEnd();
}

void Viewer::openFirst()
{
    if (!host.inputs.empty())
        state.requests.push_back(OpenScene{host.inputs.front()});
}

void Viewer::run()
{
    try {
        gpu::guarded(device, [this] { showUntilClosed(); });
    } catch (const Error& error) {
        throw Error(error.exitCode, error.what() + keepUnsaved());
    }
    state.kept.windowSize = window.sizeWithoutScale();
    if (state.kept != kept)
        keepSettings(host.configFolder, state.kept);
}

void Viewer::showUntilClosed()
{
    while (!state.closes) {
        waitForEvents();
        takeResults();
        takeDropped();
        takeWatched();
        if (window.takeCloseRequest())
            state.requests.push_back(Quit{});
        const std::optional<vk::Extent2D> size = swapchain.prepare(extentOf(window.pixels()));
        if (!size) { // minimised
            handleRequests();
            continue;
        }
        const gpu::ImageShape& shape = windowPicture.shape;
        if (!*windowPicture.handle || shape.width != size->width || shape.height != size->height) {
            swapchain.waitUntilIdle();
            windowPicture = makeCodeTarget(device, swapchain.format(), static_cast<int>(size->width),
                                           static_cast<int>(size->height), "window");
            settling = kSettlingPictures;
        }
        buildPanels();
        handleRequests();
        attempt([&] { panoramas.step(); });
        attempt([&] { stepTurntable(); });
        turnLamps();
        attempt([&] { stepMethodSearch(); });
        drawScene();
        showPicture();
        report();
    }
}

void Viewer::waitForEvents()
{
    const bool works = sceneTask.isRunning() || environmentTask.isRunning() || saveTask.isRunning();
    if (settling > 0 || state.lampsTurn || !state.requests.empty() ||
        !window.keyEvents.empty()) // of keys, a picture takes a part
        window.handleEvents(false);
    else if (works)
        window.handleEvents(kProgressSeconds);
    else if (ImGui::GetIO().WantTextInput)
        window.handleEvents(kCursorSeconds);
    else if (watchedShaders)
        window.handleEvents(kWatchSeconds);
    else {
        window.handleEvents(true);
        settling = kSettlingPictures; // whatever it was: work in the background wakes, too
    }
    settling = window.takeActivity() ? kSettlingPictures : std::max(settling - 1, 0);
}

void Viewer::takeResults()
{
    attempt([&] {
        if (sceneTask.isRunning()) {
            state.openingPart = sceneTask.part();
            if (state.cancelOpening)
                sceneTask.cancel();
            if (std::optional<OpenedScene> opened = sceneTask.take())
                show(std::move(*opened));
        }
    });
    if (!sceneTask.isRunning() || state.cancelOpening)
        state.opening.clear();
    state.reads = sceneTask.isRunning();
    if (!sceneTask.isRunning() && openNext)
        state.requests.push_back(*std::exchange(openNext, std::nullopt));
    takeEnvironment();
    attempt([&] { takeSaved(); });
}

void Viewer::takeDropped()
{
    for (const std::filesystem::path& path : window.takeDropped()) {
        state.requests.push_back(openingOf(path));
    }
}

void Viewer::takeWatched()
{
    // While a scene is saved, a change of its file is ours.
    for (WatchedFile& file : watched)
        if (!saveTask.isRunning() && file.takeChange() && state.scene)
            state.requests.push_back(OpenScene{state.scene->input, true});
    if (watchedShaders && watchedShaders->takeChange())
        state.requests.push_back(ReloadShaders{});
}

void Viewer::handleRequests()
{
    while (!state.requests.empty()) {
        const Request request = std::move(state.requests.front());
        state.requests.pop_front();
        attempt([&] { std::visit([&](const auto& r) { handle(r); }, request); });
        settling = kSettlingPictures;
    }
}

Settings Viewer::effectiveSettings() const
{
    Settings settings = state.settings;
    if (settings.view && settings.background == BackgroundKind::environment)
        settings.background = BackgroundKind::color; // as --view has it: what is no term is black
    return settings;
}

void Viewer::handle(const Quit& request)
{
    if (request.discards || !asksFirst(Quit{true}))
        state.closes = true;
}

Camera Viewer::camera() const
{
    const Scene& scene = state.scene->scene();
    if (const auto* fitted = std::get_if<FittedView>(&state.view))
        return fitCamera(scene, {.theta = fitted->theta * kPi / 180.0, .phi = fitted->phi * kPi / 180.0},
                         double(area.size.x) / area.size.y, kDefaultFov * kPi / 180.0, 2.0 * kDefaultMargin);
    if (const auto* file = std::get_if<FileView>(&state.view))
        return fitNearPlane(scene.cameras[static_cast<std::size_t>(file->index)], scene);
    return cameraOf(std::get<OrbitPose>(state.view), scene);
}

OrbitPose& Viewer::freeCamera()
{
    if (!std::holds_alternative<OrbitPose>(state.view)) {
        const Bounds& bounds = state.scene->bounds;
        state.view = poseOf(camera(), bounds.empty ? dvec3(0.0) : 0.5 * (bounds.min + bounds.max));
    }
    state.moved = true;
    return std::get<OrbitPose>(state.view);
}

void Viewer::buildPanels()
{
    if (panelLibrary.followScale()) {
        swapchain.waitUntilIdle(); // the old letters may still be shown
        panelRenderer.uploadFonts();
        settling = kSettlingPictures;
    }
    const std::vector<KeyPress> presses = panelLibrary.beginPicture();
    places.clear();
    const PanelContext context = {state, host, browser, thumbnails, panoramas, places, ImGui::GetFontSize()};
    const ImVec2 size = ImGui::GetIO().DisplaySize, scale = ImGui::GetIO().DisplayFramebufferScale;
    attempt([&] {
        const float top = drawMenu(context);
        const float bottom = drawStatus(context);
        const float column = drawColumn(context, top, size.y - bottom);
        drawDialogs(context);
        showErrors();
        drawMarks();
        handleMouse();
        handleKeys(presses);
        const ivec2 first(0, static_cast<int>(top * scale.y));
        const ivec2 beyond(static_cast<int>((size.x - column) * scale.x),
                           static_cast<int>((size.y - bottom) * scale.y));
        const Area now = {first, glm::max(beyond - first, ivec2(1))};
        state.changed |= now.size != area.size;
        area = now;
        state.settings.width = area.size.x;
        state.settings.height = area.size.y;
    });
    ImGui::Render();
}

void Viewer::report()
{
    if (host.report.empty())
        return;
    const std::string text = viewerReport(state, host, places, {area.first, area.size});
    if (text == lastReport)
        return;
    lastReport = text;
    writeReport(host.report, text);
}

} // namespace torrance
