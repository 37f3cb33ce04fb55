// What the panels read and change. They ask for what takes time, or touches files, by requests.
#pragma once

#include "study/tolerance_search.h"
#include "view/edits.h"
#include "view/error_survey.h"
#include "view/kept_settings.h"
#include "view/pixel_probe.h"
#include "view/scene_on_device.h"
#include "view/view_point.h"
#include "view/viewer_host.h"

#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace torrance {

struct OpenScene
{
    std::string input;
    bool keepsView = false; // it is the same scene, read again
    bool discards = false;  // changes that were not saved
};
struct OpenEnvironment
{
    std::string name;
};
struct SavePicture
{
    std::string file;
};
struct SaveScene
{
    std::string file;
};
/// The picture that is shown now, kept to be compared with those that follow.
struct KeepPicture
{
};
/// A picture from a file, to be compared with.
struct OpenPicture
{
    std::string file;
};
/// A picture from all around, numbered files.
struct SaveTurntable
{
    std::string file; // the first's name; "-000" is put before its ending
};
/// Another texture for a material.
struct OpenTexture
{
    std::string file;
    int material = 0;
    TextureUse Material::*role = nullptr;
};
/// One material to or from a file of its own, without textures.
struct SaveMaterial
{
    std::string file;
    int material = 0;
};
struct OpenMaterial
{
    std::string file;
    int material = 0;
};
struct ReloadShaders
{
};
/// The cheapest methods with which the picture is within a tolerance.
struct FindMethods
{
    Tolerance tolerance;
};
struct StopFinding
{
};
struct CopyCommand
{
};
struct Quit
{
    bool discards = false; // changes that were not saved
};
using Request =
    std::variant<OpenScene, OpenEnvironment, SavePicture, SaveScene, KeepPicture, OpenPicture, SaveTurntable,
                 OpenTexture, SaveMaterial, OpenMaterial, ReloadShaders, FindMethods, StopFinding, CopyCommand, Quit>;

/// The same once the changes were saved: others may have been made since.
inline Request askedAgain(Request request)
{
    std::visit(
        [](auto& r) {
            if constexpr (requires { r.discards; })
                r.discards = false;
        },
        request);
    return request;
}

/// Panoramas are environments, anything else is a scene.
inline Request openingOf(const std::filesystem::path& file)
{
    const bool panorama = file.extension() == ".hdr" || file.extension() == ".exr";
    return panorama ? Request(OpenEnvironment{file.string()}) : Request(OpenScene{file.string()});
}

struct ViewerState
{
    std::unique_ptr<SceneOnDevice> scene; // null before the first was opened
    std::optional<EditHistory> history;   // where there is a scene
    ViewPoint view = FittedView{};
    Settings settings;
    WriteSettings write; // exposure and curves, of the window and of files
    int fileSamples = 1; // per pixel, of files; the window draws one
    int selectedInstance = -1;
    int selectedMaterial = -1;

    bool changed = false; // scene or settings: to be planned and drawn anew
    bool moved = false;   // the camera or what is shown of the picture: to be drawn anew
    std::string error;    // in the words of the command line; shown until it is closed
    std::string notice;   // what was done last
    std::deque<Request> requests;
    std::string opening; // the input that is being read; empty: none
    int openingPart = 0; // OpeningPart
    bool reads = false;  // a thread is at it, though it may have been cancelled
    bool cancelOpening = false;
    std::string environmentName;           // of the light that the scene has
    std::vector<std::string> environments; // names and files that can be chosen
    std::vector<std::string> recent;       // files, newest first
    bool lampsTurn = false;
    std::string deviceName;
    double frameMs = 0.0;        // of the last picture of the scene that was drawn
    std::size_t scenesDrawn = 0; // such pictures
    bool showHelp = false, showPlan = false;
    KeptSettings kept;                           // from one time to the next
    std::string compared;                        // what the picture is compared with; empty: nothing
    float split = 0.5f;                          // part of the picture that the other one has, from the left
    std::vector<std::filesystem::path> pictures; // files of the images that were added to the scene
    bool showsErrors = false;                    // in place of the picture
    ErrorSurvey::State errors;                   // where they are shown
    bool findsMethods = false;
    int pictureTried = 0;                 // of this search
    std::optional<ToleranceResult> found; // by the last search
    std::size_t foundAt = 0;              // number of the picture it is of, of those drawn
    bool probes = false;                  // a click looks into a pixel, and selects nothing
    std::optional<PixelProbe> probe;      // the last; gone when the picture changes
    std::optional<Request> unsaved;       // what was asked for while there are changes that were not saved: asked again
    std::optional<Request> afterSaving;   // the same, once they are
    bool closes = false;

    const Edits& edits() const { return history->shown(); }
};

} // namespace torrance
