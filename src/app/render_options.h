// What `render` is asked for: read from its command line, and again from what a certificate recorded of one.
#pragma once

#include "app/camera_options.h"
#include "app/certify_option.h"
#include "app/environment_option.h"
#include "app/frame_options.h"
#include "app/light_option.h"
#include "app/output_options.h"
#include "app/scene_input.h"
#include "app/tolerance_option.h"
#include "app/view_option.h"

#include <string>
#include <vector>

namespace torrance {

struct RenderOptions
{
    std::string layers;
    bool explain = false;
    CertifyOption certify;
    ToleranceOption tolerance;
    std::string device;
    SceneOptions scene;
    FrameOptions frame;
    CameraOptions camera;
    EnvironmentOptions environment;
    LightOptions light;
    ViewOptions view;
    OutputOptions output;
    const CLI::App* app = nullptr; // that declared them
};

void declareRenderOptions(CLI::App& app, RenderOptions& options);

/// Error (usage) as of frameSettings and chooseView.
Settings renderSettings(const RenderOptions& options);

/// The options that were given and that decide what is drawn, as arguments of one input, `--name=value` each. Paths
/// that are relative become relative to `folder`.
std::vector<std::string> recordedArguments(const RenderOptions& options, const std::string& input,
                                           const std::string& folder);

/// Options out of recorded arguments; relative paths are taken from `folder`. Error (input) naming `file` where they
/// are none that this build knows.
RenderOptions optionsOfRecord(const std::vector<std::string>& arguments, const std::string& folder,
                              const std::string& file);

} // namespace torrance
