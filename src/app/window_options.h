// What `view` is asked for.
#pragma once

#include "app/camera_options.h"
#include "app/environment_option.h"
#include "app/frame_options.h"
#include "app/light_option.h"
#include "app/output_options.h"
#include "app/scene_input.h"
#include "app/view_option.h"

#include <string>
#include <vector>

namespace torrance {

struct WindowOptions
{
    SceneOptions scene;
    FrameOptions frame; // its resolution is the window's size
    CameraOptions camera;
    EnvironmentOptions environment;
    LightOptions light;
    ViewOptions view;
    std::string methods = "shipped"; // the table that a tolerance chooses from
    OutputOptions output;            // curves and exposure only
    std::string device;
    bool watch = false;
    bool validation = false;
    std::string report;
    const CLI::App* app = nullptr; // that declared them
};

void declareWindowOptions(CLI::App& app, WindowOptions& options);

/// Whether the window's size was given.
bool choosesSize(const WindowOptions& options);

/// The options that say what the scene is and are not changed in the window, as they were given.
std::vector<std::string> lastingArguments(const WindowOptions& options);

} // namespace torrance
