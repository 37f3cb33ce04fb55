// What comes into the window: scenes, environments, textures, materials.
#include "view/viewer.h"

#include "core/error.h"
#include "core/read_file.h"
#include "files/material_file.h"
#include "files/texture_file.h"
#include "view/kept_settings.h"

#include <algorithm>
#include <filesystem>

namespace torrance {

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
    EnvironmentChoice choice = first ? host.environment : state.edits().environment;
    if (!first)
        choice.name = state.environmentName; // another may have been chosen, and not be there yet
    std::optional<Environment> known;
    if (!first && state.scene->scene().environment)
        known = state.scene->scene().environment;
    sceneTask.start([this, request, choice, first, known = std::move(known),
                     settings = effectiveSettings()](Progress& progress) mutable {
        LoadedScene loaded = host.loadScene(request.input, progress.stopToken());
        loaded.scene.environment = first ? host.loadEnvironment(choice) : std::move(known);
        return OpenedScene{putOnDevice(renderer, std::move(loaded), request.input, settings, progress), choice,
                           request.keepsView};
    });
}

void Viewer::show(OpenedScene opened)
{
    stopReading();
    swapchain.waitUntilIdle(); // thumbnails of the old scene may still be drawn
    thumbnails.clear();
    turntable.reset();
    state.pictures.clear();
    state.scene = std::move(opened.scene);
    const Scene& scene = state.scene->scene();
    Edits read = editsOf(scene, opened.environment);
    const bool goesOn = opened.keepsView && state.history && state.history->goOnWith(read, scene.textures.size());
    if (!goesOn)
        state.history.emplace(std::move(read));
    state.environmentName = opened.environment.name;
    offerEnvironment(state.environmentName);
    if (!goesOn || state.selectedInstance >= static_cast<int>(scene.instances.size()))
        state.selectedInstance = state.selectedMaterial = -1;
    const auto* file = std::get_if<FileView>(&state.view);
    if (!opened.keepsView || (file && file->index >= static_cast<int>(scene.cameras.size())))
        state.view = FittedView{};
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
    chooseFirstCamera();
}

// Of the first scene alone. An Error where the command line's options do not fit it: it is seen as a whole then.
void Viewer::chooseFirstCamera()
{
    const bool chooses = std::exchange(host.choosesCamera, false);
    const int index = std::exchange(host.firstFileCamera, -1);
    if (!chooses && index < 0)
        return;
    const Camera chosen = host.firstCamera(state.scene->scene(), double(area.size.x) / area.size.y);
    if (index >= 0) {
        state.view = FileView{index};
        return;
    }
    const Bounds& bounds = state.scene->bounds;
    state.view = poseOf(chosen, bounds.empty ? dvec3(0.0) : 0.5 * (bounds.min + bounds.max));
}

void Viewer::handle(const OpenEnvironment& request)
{
    if (!state.history)
        return;
    Edits edits = state.history->now();
    edits.environment.name = request.name;
    state.history->commit(std::move(edits));
}

void Viewer::offerEnvironment(const std::string& name)
{
    if (std::ranges::find(state.environments, name) == state.environments.end())
        state.environments.push_back(name);
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
    stopReading();
    state.scene->scene().environment = std::move(opened.environment);
    state.environmentName = opened.name;
    offerEnvironment(opened.name);
    state.notice = "environment " + opened.name;
    state.changed = true;
}

// A file was chosen for it meanwhile, and the material may have been undone.
Material& Viewer::chosenMaterial(Edits& edits, int material) const
{
    if (material < 0 || static_cast<std::size_t>(material) >= edits.materials.size())
        throw usageError("the material is not there any more", "choose another");
    return edits.materials[static_cast<std::size_t>(material)];
}

void Viewer::handle(const OpenTexture& request)
{
    if (!state.scene)
        return;
    Edits edits = state.history->now();
    TextureUse& use = chosenMaterial(edits, request.material).*request.role;
    const std::vector<std::byte> bytes = readFile(request.file);
    TextureImage image = decodeTexture(bytes, std::filesystem::path(request.file).filename().string(), request.file);
    stopReading();
    Scene& scene = state.scene->scene();
    scene.images.push_back(std::move(image));
    scene.textures.push_back({.image = static_cast<int>(scene.images.size()) - 1, .sampler = {}});
    state.pictures.emplace_back(std::filesystem::absolute(request.file));
    use.texture = static_cast<int>(scene.textures.size()) - 1; // where it is put stays
    state.history->commit(std::move(edits));
    state.changed = true;
}

void Viewer::handle(const OpenMaterial& request)
{
    const LoadedMaterial loaded = loadMaterial(request.file);
    Edits edits = state.history->now();
    Material& material = chosenMaterial(edits, request.material);
    material = withTexturesOf(material, loaded.material);
    state.history->commit(std::move(edits));
    state.changed = true;
    state.notice = "material of " + request.file;
    for (const std::string& warning : loaded.warnings)
        state.notice += "; " + warning;
}

} // namespace torrance
