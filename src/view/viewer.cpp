#include "view/viewer.h"

#include "core/error.h"
#include "core/log.h"
#include "core/read_file.h"
#include "files/image_read.h"
#include "files/texture_file.h"
#include "image/linear_scale.h"
#include "image/quantize.h"
#include "image/srgb.h"
#include "passes/targets.h"
#include "plan/pixel_sampling_plan.h"
#include "study/error_picture.h"
#include "view/kept_settings.h"
#include "view/render_command.h"
#include "view/saved_scene.h"
#include "view/screen_place.h"
#include "view/selection_box.h"
#include "view/viewer_report.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>

namespace torrance {
namespace {

constexpr double kProgressSeconds = 0.1; // between two looks at work in the background
constexpr double kWatchSeconds = 0.5;    // between two looks at files
constexpr double kCursorSeconds = 0.4;   // between two pictures while a text is typed
constexpr int kSettlingPictures = 2;     // after something has happened: panels lay themselves out in the second

gpu::DeviceOptions deviceOptions(const ViewerHost& host, const Window& window)
{
    return {.choice = host.deviceChoice, .validation = host.validation, .windowExtensions = window.extensions()};
}

vk::Extent2D extentOf(const ivec2& size)
{
    return {static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y)};
}

constexpr double kFov = 45.0 * kPi / 180.0, kMargin = 0.05; // those of `torrance render`

} // namespace

template <typename Work>
void Viewer::attempt(Work work)
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
    : host(std::move(h)), window("Torrance", host.windowSize), panelLibrary(window),
      device(deviceOptions(host, window)), shaders(host.shaderFolder, host.cacheFolder),
      renderer(device, shaders, host.cacheFolder), swapchain(device, window.makeSurface(device)),
      display(device, shaders, swapchain.format()), panelRenderer(device, shaders, swapchain.format()),
      thumbnails(device), survey(Window::wake), sceneTask(Window::wake), environmentTask(Window::wake)
{
    state.settings = host.settings;
    state.fileSamples = host.settings.samples;
    if (!shadesOncePerPixel(state.settings))
        state.settings.samples = 1;
    state.write = host.write;
    state.deviceName = device.description.name;
    state.recent = loadRecent(host.configFolder);
    state.environments = host.environments;
    openFirst();
}

Viewer::~Viewer()
{
    swapchain.waitUntilIdle();
}

void Viewer::openFirst()
{
    if (host.firstFileCamera >= 0)
        state.view = FileView{host.firstFileCamera};
    if (!host.inputs.empty())
        state.requests.push_back(OpenScene{host.inputs.front(), host.firstFileCamera >= 0});
}

void Viewer::run()
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
        attempt([&] { stepTurntable(); });
        drawScene();
        showPicture();
        report();
    }
}

void Viewer::waitForEvents()
{
    const bool works = sceneTask.isRunning() || environmentTask.isRunning();
    if (!window.keyEvents.empty()) // of which one picture takes a part
        settling = std::max(settling, kSettlingPictures);
    if (settling > 0 || !state.requests.empty()) {
        --settling;
        window.handleEvents(false);
        return;
    }
    if (works)
        window.handleEvents(kProgressSeconds);
    else if (ImGui::GetIO().WantTextInput)
        window.handleEvents(kCursorSeconds);
    else if (!watched.empty())
        window.handleEvents(kWatchSeconds);
    else
        window.handleEvents(true);
    settling = kSettlingPictures;
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
    if (!sceneTask.isRunning() && openNext)
        state.requests.push_back(*std::exchange(openNext, std::nullopt));
    takeEnvironment();
}

void Viewer::takeEnvironment()
{
    try {
        if (std::optional<OpenedEnvironment> opened = environmentTask.take())
            show(std::move(*opened));
    } catch (const Error& error) {
        state.error = error.what();
        Edits edits = state.history->now();
        edits.environment.name = state.environmentName; // the one that is still there
        state.history->commit(std::move(edits));
    }
    // Chosen, undone or redone: what lights the scene follows.
    if (state.history && !environmentTask.isRunning() && state.edits().environment.name != state.environmentName)
        startReadingEnvironment(state.edits().environment);
}

void Viewer::takeDropped()
{
    for (const std::filesystem::path& path : window.takeDropped()) {
        state.requests.push_back(openingOf(path));
    }
}

void Viewer::takeWatched()
{
    for (WatchedFile& file : watched)
        if (file.takeChange() && state.scene)
            state.requests.push_back(OpenScene{state.scene->input, true});
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

bool Viewer::asksFirst(const Request& request)
{
    if (!state.history || !state.history->isDirty())
        return false;
    state.unsaved = request;
    return true;
}

void Viewer::handle(const OpenScene& request)
{
    if (!request.discards && asksFirst(OpenScene{request.input, request.keepsView, true}))
        return;
    if (sceneTask.isRunning()) {
        sceneTask.cancel();
        openNext = request; // when that has ended
        return;
    }
    state.opening = request.input;
    state.openingPart = kReading;
    state.cancelOpening = false;
    const bool first = !state.history;
    const EnvironmentChoice choice = first ? host.environment : state.edits().environment;
    std::optional<Environment> known;
    if (!first && state.scene->scene().environment)
        known = state.scene->scene().environment;
    sceneTask.start([this, request, choice, first, known = std::move(known),
                     settings = effectiveSettings()](Progress& progress) mutable {
        LoadedScene loaded = host.loadScene(request.input);
        loaded.scene.environment = first ? host.loadEnvironment(choice) : std::move(known);
        return OpenedScene{putOnDevice(renderer, std::move(loaded), request.input, settings, progress), choice,
                           request.keepsView};
    });
}

void Viewer::show(OpenedScene opened)
{
    survey.stop();
    swapchain.waitUntilIdle(); // thumbnails of the old scene may still be drawn
    thumbnails.clear();
    turntable.reset();
    state.pictures.clear();
    state.scene = std::move(opened.scene);
    state.history.emplace(editsOf(state.scene->scene(), opened.environment));
    state.environmentName = opened.environment.name;
    state.selectedInstance = -1;
    state.selectedMaterial = -1;
    const auto* file = std::get_if<FileView>(&state.view);
    if (!opened.keepsView || (file && file->index >= static_cast<int>(state.scene->scene().cameras.size())))
        state.view = FittedView{};
    if (host.choosesCamera && picturesShown == 0)
        state.view = poseOf(host.firstCamera(state.scene->scene(), double(area.size.x) / area.size.y),
                            0.5 * (state.scene->bounds.min + state.scene->bounds.max));
    state.changed = true; // the window may have another size by now
    state.opening.clear();
    window.setTitle(state.scene->input + " - Torrance");
    std::error_code failure;
    if (std::filesystem::is_regular_file(state.scene->input, failure)) {
        browser.setFolder(std::filesystem::absolute(state.scene->input).parent_path());
        state.recent = keepRecent(host.configFolder, state.recent, state.scene->input);
        watched.clear();
        if (host.watch)
            watched.emplace_back(state.scene->input);
    }
}

void Viewer::handle(const OpenEnvironment& request)
{
    if (!state.history)
        return;
    Edits edits = state.history->now();
    edits.environment.name = request.name;
    state.history->commit(std::move(edits));
}

void Viewer::startReadingEnvironment(const EnvironmentChoice& choice)
{
    state.notice = "reading " + choice.name;
    ShadingPlan plan = state.scene->plan;
    plan.environmentLight = true;
    environmentTask.start([this, choice, plan = std::move(plan)](Progress& progress) {
        OpenedEnvironment opened = {choice.name, host.loadEnvironment(choice)};
        progress.enter(1);
        if (opened.environment) {
            Scene light;
            light.environment = opened.environment;
            renderer.prepareEnvironment(light, plan);
        }
        return opened;
    });
}

void Viewer::show(OpenedEnvironment opened)
{
    survey.stop();
    state.scene->scene().environment = std::move(opened.environment);
    state.environmentName = opened.name;
    if (std::ranges::find(state.environments, opened.name) == state.environments.end())
        state.environments.push_back(opened.name);
    state.notice = "environment " + opened.name;
    state.changed = true;
}

Picture Viewer::renderForFile(const Camera& from)
{
    Settings settings = effectiveSettings();
    settings.samples = shadesOncePerPixel(settings) ? settings.samples : state.fileSamples;
    replan(renderer, *state.scene, settings);
    state.changed = true; // back to one sample
    return renderer.render(*state.scene->device, from);
}

void Viewer::handle(const SavePicture& request)
{
    if (!state.scene)
        return;
    imageFormatOf(request.file); // refuses what it does not know before anything is drawn
    Picture picture = renderForFile(camera());
    host.writePicture(request.file, std::move(picture), state.scene->plan.settings, state.write);
    state.notice = "saved " + request.file;
}

void Viewer::handle(const SaveTurntable& request)
{
    if (!state.scene)
        return;
    imageFormatOf(request.file);
    turntable = Turntable{.file = request.file, .pose = freeCamera(), .frames = state.turntableFrames};
}

void Viewer::stepTurntable()
{
    if (!turntable)
        return;
    OrbitPose pose = turntable->pose;
    orbit(pose, 360.0 * turntable->next / turntable->frames, 0.0);
    const std::filesystem::path file =
        turntable->file.parent_path() / fmt::format("{}-{:03}{}", turntable->file.stem().string(), turntable->next,
                                                    turntable->file.extension().string());
    try {
        Picture picture = renderForFile(cameraOf(pose, state.scene->scene()));
        host.writePicture(file.string(), std::move(picture), state.scene->plan.settings, state.write);
    } catch (const Error&) {
        turntable.reset();
        throw;
    }
    state.notice = fmt::format("saved {} ({} of {})", file.string(), turntable->next + 1, turntable->frames);
    if (++turntable->next == turntable->frames)
        turntable.reset();
    settling = kSettlingPictures;
}

void Viewer::handle(const SaveScene& request)
{
    const bool overSource =
        std::filesystem::weakly_canonical(request.file) == std::filesystem::weakly_canonical(state.scene->input);
    host.saveScene(state.scene->input, sceneToSave(*state.history, state.scene->scene(), state.pictures), request.file);
    state.history->markSaved();
    state.notice = "saved " + request.file;
    if (overSource) // what is edited from now on is an edit of the new file
        state.requests.push_back(OpenScene{state.scene->input, true});
}

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
}

void Viewer::handle(const OpenTexture& request)
{
    if (!state.scene)
        return;
    const std::vector<std::byte> bytes = readFile(request.file);
    TextureImage image = decodeTexture(bytes, std::filesystem::path(request.file).filename().string(), request.file);
    survey.stop(); // it reads the scene
    Scene& scene = state.scene->scene();
    scene.images.push_back(std::move(image));
    scene.textures.push_back({.image = static_cast<int>(scene.images.size()) - 1, .sampler = {}});
    state.pictures.emplace_back(std::filesystem::absolute(request.file));
    Edits edits = state.history->now();
    TextureUse& use = edits.materials[static_cast<std::size_t>(request.material)].*request.role;
    use.texture = static_cast<int>(scene.textures.size()) - 1; // where it is put stays
    state.history->commit(std::move(edits));
    state.changed = true;
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

void Viewer::handle(const CopyCommand&)
{
    if (!state.scene)
        return;
    const RenderCommand command = renderCommandOf(state, host);
    ImGui::SetClipboardText(command.text.c_str());
    state.notice = "copied the command";
    for (const std::string& lost : command.lost)
        state.notice += "; changed " + lost + " are not in it";
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
                         double(area.size.x) / area.size.y, kFov, 2.0 * kMargin);
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
    const std::vector<KeyPress> presses = panelLibrary.beginPicture();
    places.clear();
    const PanelContext context = {state, host, browser, thumbnails, places, ImGui::GetFontSize()};
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
            const gpu::DeviceImage& drawn = renderer.frame(state.scene->plan);
            if (view->scale)
                shownTerm = {.factor = view->scale->factor, .offset = view->scale->offset};
            else if (const double greatest = greatestValue(readBack(device, drawn)); greatest > 0.0)
                shownTerm.factor = 1.0 / greatest;
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

void Viewer::drawMarks()
{
    if (!state.scene)
        return;
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
    if (state.selectedInstance >= 0)
        for (const ScreenLine& line :
             selectionBox(state.scene->scene(), state.selectedInstance, shownCamera, area.size))
            list.AddLine(inWindow(line.begin), inWindow(line.end), kSelected, 1.5f);
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

// Of the picture that is drawn: a term has none.
DisplaySettings Viewer::shownCurves() const
{
    if (state.scene->plan.settings.view)
        return {.tone = findToneCurve("none")};
    return {.exposure = state.write.exposure, .tone = state.write.tone, .transfer = state.write.transfer};
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
    ++picturesShown;
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
