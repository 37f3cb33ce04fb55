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

const std::vector<std::string> kPictures = {".png", ".exr", ".jpg", ".webp", ".hdr"};

// Asks for a file, and then for what Save does with it.
template <typename Save>
void askWhere(const PanelContext& context, const char* title, std::vector<std::string> endings, std::string name)
{
    ViewerState& state = context.state;
    context.browser.ask(
        {.title = title,
         .endings = std::move(endings),
         .saves = true,
         .name = std::move(name),
         .chosen = [&state](const std::filesystem::path& path) { state.requests.push_back(Save{path.string()}); }});
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

void askForEnvironment(const PanelContext& context)
{
    ViewerState& state = context.state;
    context.browser.ask({.title = "Open a panorama",
                         .endings = {".hdr", ".exr"},
                         .saves = false,
                         .name = {},
                         .chosen = [&state](const std::filesystem::path& path) {
                             state.requests.push_back(OpenEnvironment{path.string()});
                         }});
}

void askForPicture(const PanelContext& context)
{
    askWhere<SavePicture>(context, "Save the picture", kPictures, stemOf(context.state) + ".png");
}

void askForTurntable(const PanelContext& context)
{
    askWhere<SaveTurntable>(context, "Save pictures from all around", kPictures, stemOf(context.state) + "-turn.png");
}

void askForSave(const PanelContext& context)
{
    askWhere<SaveScene>(context, "Save the scene", {".gltf", ".glb"},
                        std::filesystem::path(context.state.scene->input).filename().string());
}

} // namespace torrance
