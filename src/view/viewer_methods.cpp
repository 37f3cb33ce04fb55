// Methods for a tolerance: looked for beside everything else, with pictures that the window draws and shows.
#include "view/viewer.h"

#include "passes/targets.h"

namespace torrance {

void Viewer::handle(const FindMethods& request)
{
    if (!state.scene)
        return;
    stopReading();
    takeEdits(); // they are what the search reads
    shownCamera = camera();
    Settings asked = state.scene->plan.settings;
    asked.backgroundBlur = 0.0; // what is seen through blended surfaces has no exact value with it
    search.start(state.scene->scene(), shownCamera, asked, host.methodTable(device.description), request.tolerance);
    state.findsMethods = true;
    state.found.reset();
}

void Viewer::handle(const StopFinding&)
{
    if (state.findsMethods)
        state.changed = true; // back to the methods that were chosen
    stopFinding();
}

void Viewer::stopReading()
{
    survey.stop();
    stopFinding();
}

void Viewer::stopFinding()
{
    search.stop();
    state.findsMethods = false;
    state.pictureTried = 0;
}

// Draws what the search waits for, and takes what it has found.
void Viewer::stepMethodSearch()
{
    if (!state.findsMethods)
        return;
    if (state.changed || state.moved) {
        stopFinding();
        state.notice = "the search for methods has ended: the picture is another";
        return;
    }
    try {
        if (const std::optional<Settings> wanted = search.wanted()) {
            replan(renderer, *state.scene, *wanted);
            drawFrame();
            ++state.pictureTried;
            settling = kSettlingPictures;
            search.give(readBack(device, renderer.frame(state.scene->plan)));
        }
        if (std::optional<ToleranceResult> result = search.take()) {
            takeMethods(std::move(*result));
            stopFinding();
        }
    } catch (...) {
        stopFinding();
        state.changed = true;
        throw;
    }
}

void Viewer::takeMethods(ToleranceResult result)
{
    settling = kSettlingPictures;
    state.changed = true;
    if (result.certificate.covered == 0) {
        state.notice = "no surface is seen, and nothing can be compared";
        return;
    }
    state.settings.methods = result.settings.methods;
    state.settings.environmentSamples = result.settings.environmentSamples;
    state.settings.lightSamples = result.settings.lightSamples;
    state.found = std::move(result);
    state.foundAt = state.scenesDrawn + 1;
}

} // namespace torrance
