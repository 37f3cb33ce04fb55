// What the file browser is asked for.
#include "view/file_browser.h"
#include "view/panels.h"

#include <filesystem>

namespace torrance {
namespace {

std::string stemOf(const ViewerState& state)
{
    return std::filesystem::path(state.scene->input).stem().string();
}

} // namespace

void askForScene(const PanelContext& context)
{
    ViewerState& state = context.state;
    context.browser.ask(
        {.title = "Open a scene or an environment",
         .endings = {".gltf", ".glb", ".obj", ".hdr", ".exr"},
         .saves = false,
         .name = {},
         .chosen = [&state](const std::filesystem::path& path) { state.requests.push_back(openingOf(path)); }});
}

void askForPicture(const PanelContext& context)
{
    ViewerState& state = context.state;
    context.browser.ask({.title = "Save the picture",
                         .endings = {".png", ".exr", ".jpg", ".webp", ".hdr"},
                         .saves = true,
                         .name = stemOf(state) + ".png",
                         .chosen = [&state](const std::filesystem::path& path) {
                             state.requests.push_back(SavePicture{path.string()});
                         }});
}

void askForTurntable(const PanelContext& context)
{
    ViewerState& state = context.state;
    context.browser.ask({.title = "Save pictures from all around",
                         .endings = {".png", ".exr", ".jpg", ".webp"},
                         .saves = true,
                         .name = stemOf(state) + "-turn.png",
                         .chosen = [&state](const std::filesystem::path& path) {
                             state.requests.push_back(SaveTurntable{path.string()});
                         }});
}

void askForSave(const PanelContext& context)
{
    ViewerState& state = context.state;
    context.browser.ask({.title = "Save the scene",
                         .endings = {".gltf", ".glb"},
                         .saves = true,
                         .name = std::filesystem::path(state.scene->input).filename().string(),
                         .chosen = [&state](const std::filesystem::path& path) {
                             state.requests.push_back(SaveScene{path.string()});
                         }});
}

} // namespace torrance
