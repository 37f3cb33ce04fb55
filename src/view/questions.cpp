// What the file browser is asked for.
#include "view/file_browser.h"
#include "view/panels.h"

#include <algorithm>
#include <filesystem>

namespace torrance {
namespace {

std::string stemOf(const ViewerState& state)
{
    return std::filesystem::path(state.scene->input).stem().string();
}

const std::vector<std::string> kSavable = {".gltf", ".glb"};

// The scene's own file, where it can be saved to that; else one that holds all of it.
std::string nameToSave(const ViewerState& state)
{
    const std::filesystem::path file = std::filesystem::path(state.scene->input).filename();
    const bool savable = std::ranges::find(kSavable, file.extension().string()) != kSavable.end();
    return savable ? file.string() : stemOf(state) + ".glb";
}

const std::vector<std::string> kPictures = {".png", ".exr", ".jpg", ".webp", ".hdr"};

// Asks for a file to read, or where a name is offered, to write, and then for what Asked does with it.
template <typename Asked>
void ask(const PanelContext& context, const char* title, std::vector<std::string> endings, std::string name = {})
{
    ViewerState& state = context.state;
    context.browser.ask(
        {.title = title,
         .endings = std::move(endings),
         .saves = !name.empty(),
         .name = std::move(name),
         .chosen = [&state](const std::filesystem::path& path) { state.requests.push_back(Asked{path.string()}); }});
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
    ask<OpenEnvironment>(context, "Open a panorama", {".hdr", ".exr"});
}

void askForComparison(const PanelContext& context)
{
    ask<OpenPicture>(context, "Compare with a picture", {".png", ".exr", ".hdr", ".jpg", ".jpeg", ".webp"});
}

void askForPicture(const PanelContext& context)
{
    ask<SavePicture>(context, "Save the picture", kPictures, stemOf(context.state) + ".png");
}

void askForTurntable(const PanelContext& context)
{
    ask<SaveTurntable>(context, "Save pictures from all around", kPictures, stemOf(context.state) + "-turn.png");
}

void askForSave(const PanelContext& context)
{
    ask<SaveScene>(context, "Save the scene", kSavable, nameToSave(context.state));
}

void askForSaveBefore(const PanelContext& context, const Request& waiting)
{
    ViewerState& state = context.state;
    context.browser.ask({.title = "Save the scene",
                         .endings = kSavable,
                         .saves = true,
                         .name = nameToSave(state),
                         .chosen = [&state, waiting](const std::filesystem::path& path) {
                             state.requests.push_back(SaveScene{path.string()});
                             state.afterSaving = askedAgain(waiting);
                         }});
}

} // namespace torrance
