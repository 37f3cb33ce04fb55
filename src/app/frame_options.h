// How a frame is drawn, whatever becomes of it, by options that several commands share.
#pragma once

#include "app/method_options.h"
#include "app/picture_options.h"
#include "plan/settings.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace torrance {

struct FrameOptions
{
    PictureOptions picture;
    std::optional<double> backgroundBlur;
    int samples = 1;
    std::string path = "auto";
    std::string triangleCulling = "auto";
    MethodOptions methods;
    std::optional<int> environmentSamples;
    std::optional<int> lightSamples;
    std::vector<std::string> ofMaterials; // material_method_option.h
};

/// The options of the picture, --background-blur, --samples, --path, --triangle-culling, those of the methods,
/// --environment-samples, --light-samples and --material-methods.
void declareFrameOptions(CLI::App& app, FrameOptions& options);

/// Error (usage) where a picture is too large for this machine, options contradict each other or have no effect.
Settings frameSettings(const FrameOptions& options, bool layers = false);

} // namespace torrance
