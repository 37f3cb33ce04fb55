// The window: what it shows, and what it does when something happens.
#pragma once

#include "gpu/swapchain.h"
#include "passes/display_pass.h"
#include "passes/outline_pass.h"
#include "view/file_browser.h"
#include "view/kept_settings.h"
#include "view/method_search.h"
#include "view/panel_library.h"
#include "view/panel_renderer.h"
#include "view/panels.h"
#include "view/panorama_thumbnails.h"
#include "view/thumbnails.h"
#include "view/viewer_host.h"
#include "view/viewer_state.h"
#include "view/watched_file.h"
#include "view/window.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace torrance {

/// Pictures of the window after something has happened: panels lay themselves out in the second.
inline constexpr int kSettlingPictures = 2;

class Viewer
{
public:
    /// Opens the window. Errors (noDevice) where there is no display, or no device that can show pictures on it.
    explicit Viewer(ViewerHost host);
    ~Viewer();

    /// Until it is closed. Where the device fails, an Error (deviceFailure), which says what became of edits that were
    /// not saved: they are kept in a file of their own.
    void run();

    std::vector<std::string> validationMessages() const { return device.validationMessages(); }

private:
    struct OpenedScene
    {
        std::unique_ptr<SceneOnDevice> scene;
        EnvironmentChoice environment;
        bool keepsView = false;
    };
    struct OpenedEnvironment
    {
        std::string name;
        std::optional<Environment> environment;
    };
    struct SavedScene
    {
        std::shared_ptr<SceneSource> source;
        std::string file;
        Edits edits; // that are in it
    };
    // The part of the window where the picture is, in its pixels.
    struct Area
    {
        ivec2 first = ivec2(0);
        ivec2 size = ivec2(1);
    };

    void showUntilClosed();
    std::string keepUnsaved();
    Settings effectiveSettings() const;
    void openFirst();
    void waitForEvents();
    void takeResults();
    void takeEnvironment();
    void takeSaved();
    SceneToSave toSave() const;
    void startReadingEnvironment(const EnvironmentChoice& choice);
    void takeDropped();
    void takeWatched();
    void handle(const OpenScene& request);
    void handle(const OpenEnvironment& request);
    void handle(const SavePicture& request);
    void handle(const SaveScene& request);
    void handle(const KeepPicture& request);
    void handle(const OpenPicture& request);
    void handle(const SaveTurntable& request);
    void handle(const OpenTexture& request);
    void handle(const SaveMaterial& request);
    void handle(const OpenMaterial& request);
    void handle(const ReloadShaders& request);
    void handle(const FindMethods& request);
    void handle(const StopFinding& request);
    void handle(const CopyCommand& request);
    void handle(const Quit& request);
    void handleRequests();
    bool
    asksFirst(const Request& request); // whether changes would be lost: then that is asked before `request` is done
    void show(OpenedScene opened);
    void show(OpenedEnvironment opened);
    void offerEnvironment(const std::string& name); // from now on
    void chooseFirstCamera();
    Material& chosenMaterial(Edits& edits, int material) const; // Error (usage) where it is gone

    void buildPanels();
    void handleMouse();
    void handleKeys(const std::vector<KeyPress>& presses);
    void handleCameraKey(const KeyPress& press);
    void handleControlKey(const KeyPress& press);
    bool closeDialog();
    void frameAll();
    void frameSelection();
    void nextFileCamera();
    OrbitPose& freeCamera();
    Camera camera() const;
    void pickAt(const vec2& place, bool looksAtIt);
    void rotateEnvironment(double degrees);
    int lampAt(const vec2& place) const; // of the lights; -1: none
    void moveLamp(const vec2& pixels);
    void turnLamps();

    void drawScene();
    void takeEdits();
    void drawFrame();
    Picture renderForFile(const Camera& camera);
    void stepTurntable();
    void replanOrGoBack();
    WriteSettings curves() const;
    DisplaySettings shownCurves() const;
    void stopReading(); // of the scene, by what runs beside the window: before it is changed
    void stopFinding();
    void stepMethodSearch();
    void takeMethods(ToleranceResult result);
    void surveyErrors();
    void showErrors();
    void drawOutline();
    void drawMarks();
    void probeAt(const vec2& place);
    void showPicture();
    void report();

    void attempt(const std::function<void()>& work); // an Error becomes state.error

    ViewerHost host;
    const KeptSettings kept; // as they were found
    Window window;
    PanelLibrary panelLibrary;
    gpu::Device device;
    gpu::ShaderLibrary shaders;
    Renderer renderer;
    ViewerState state; // with a scene on the device
    gpu::Swapchain swapchain;
    DisplayPass display;
    OutlinePass outline;
    PanelRenderer panelRenderer;
    Thumbnails thumbnails;
    PanoramaThumbnails panoramas;
    FileBrowser browser;
    Places places;
    gpu::DeviceImage windowPicture;
    Area area;
    Settings plannedSettings; // the last that could be planned
    Camera shownCamera;       // of the picture that is shown
    bool hasFrame = false;    // the renderer holds a picture of the scene
    // What the picture is compared with.
    struct Compared
    {
        gpu::DeviceImage image;
        DisplaySettings curves; // as it was shown when it was kept; a file of codes has none
        DisplayPlace term;      // likewise
    };
    Compared compared;
    // Pictures from all around that are still to be saved.
    struct Turntable
    {
        std::filesystem::path file;
        OrbitPose pose;
        int frames = 0;
        int next = 0;
    };
    std::optional<Turntable> turntable;
    ErrorSurvey survey;
    MethodSearch search;
    gpu::DeviceImage errorImage; // what of it is shown
    // The line around what is selected, and what it was drawn for.
    struct Outlined
    {
        int instance = -1;
        std::size_t picture = 0; // number of the scene's picture
        const gpu::DeviceImage* line = nullptr;
    };
    Outlined outlined;
    DisplayPlace shownTerm;                // how the numbers of a term are shown
    BackgroundTask<OpenedScene> sceneTask; // with a scene on the device, too
    BackgroundTask<OpenedEnvironment> environmentTask;
    BackgroundTask<SavedScene> saveTask;
    std::optional<OpenScene> openNext;         // after the one that is being opened
    std::optional<WatchedFile> watchedShaders; // with --watch
    std::vector<WatchedFile> watched;
    vec2 pressedAt = vec2(0.0f), lastPlace = vec2(0.0f); // of the arrow, in the window's pixels
    static constexpr float kLampRadius = 5.0f;           // pixels, of the mark that a lamp is taken by
    int draggedLamp = -1;
    std::optional<std::chrono::steady_clock::time_point> lampsTurnedAt; // where they turn
    bool dragging = false, draggedFar = false;                          // since a button was pressed in the picture
    int settling = 0; // pictures of the window still to be made: panels take two to come to rest
    std::string lastReport;
};

} // namespace torrance
