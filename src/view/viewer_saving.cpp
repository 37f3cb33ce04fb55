// What leaves the window: pictures, scenes, materials, commands.
#include "view/viewer.h"

#include "core/error.h"
#include "core/log.h"
#include "files/material_file.h"
#include "plan/pixel_sampling_plan.h"
#include "view/recovery.h"
#include "view/render_command.h"
#include "view/saved_scene.h"

#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>

namespace torrance {

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
    host.writePicture(request.file, std::move(picture), state.scene->plan.settings, curves());
    state.notice = "saved " + request.file;
}

void Viewer::handle(const SaveTurntable& request)
{
    if (!state.scene)
        return;
    imageFormatOf(request.file);
    turntable = Turntable{.file = request.file, .pose = freeCamera(), .frames = state.kept.turntableFrames};
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
        host.writePicture(file.string(), std::move(picture), state.scene->plan.settings, curves());
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
    if (!state.scene)
        return;
    if (saveTask.isRunning())
        throw usageError("a scene is being saved", "save again when that is done");
    state.notice = "saving " + request.file;
    saveTask.start([this, source = state.scene->source, file = request.file, edits = state.history->now(),
                    scene = toSave()](Progress&) mutable {
        const auto write = [&](const std::filesystem::path& copy) {
            scene.sourceCopy = copy;
            host.saveScene(scene, file);
        };
        source->isFile(file) ? source->writeOver(write) : write(source->copy());
        return SavedScene{source, file, std::move(edits)};
    });
}

SceneToSave Viewer::toSave() const
{
    SceneToSave scene = sceneToSave(*state.history, state.scene->scene(), state.pictures);
    scene.input = state.scene->input;
    return scene;
}

void Viewer::takeSaved()
{
    if (!saveTask.isEnded())
        return;
    const std::optional<Request> waiting = std::exchange(state.afterSaving, std::nullopt); // not where saving fails
    const std::optional<SavedScene> saved = saveTask.take();
    if (!saved)
        return;
    state.notice = "saved " + saved->file;
    if (waiting)
        state.requests.push_back(*waiting);
    if (!state.scene || saved->source != state.scene->source)
        return; // another was opened meanwhile
    state.history->markSaved(saved->edits);
    for (WatchedFile& file : watched)
        file.takeChange(); // of our own making
}

// What became of edits that no file has, as the rest of a message; empty where there are none.
std::string Viewer::keepUnsaved()
{
    if (!state.history)
        return {};
    state.history->commit(state.edits()); // a slider may still be held
    saveTask.wait();
    try {
        takeSaved();
    } catch (const Error& error) {
        logWarning(error.what());
    }
    if (!state.history->isDirty())
        return {};
    try {
        const std::filesystem::path file = recoveryFile(host.stateFolder, state.scene->input);
        SceneToSave scene = toSave();
        scene.sourceCopy = state.scene->source->copy();
        host.saveScene(scene, file.string());
        keepRecent(host.configFolder, state.recent, file.string());
        return "; the changes that were not saved are in " + file.string();
    } catch (const Error& error) {
        return std::string("; the changes that were not saved are lost: ") + error.what();
    }
}

void Viewer::handle(const SaveMaterial& request)
{
    Edits edits = state.history->now();
    const Material& material = chosenMaterial(edits, request.material);
    state.notice = "saved " + request.file;
    for (const std::string& left : saveMaterial(material, request.file))
        state.notice += "; " + left;
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

} // namespace torrance
