// One term of the shading equation instead of the picture: --view.
#pragma once

#include "app/output_options.h"
#include "files/json_write.h"
#include "passes/renderer.h"
#include "plan/settings.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace torrance {

struct ViewOptions
{
    std::string view; // "" = the picture
    std::optional<int> light;
};

void declareViewOptions(CLI::App& app, ViewOptions& options);

/// Sets the settings' view. What stands behind the surfaces is black then, unless a background was asked for. Error
/// (usage) for options that would have no effect.
void chooseView(const ViewOptions& options, const OutputOptions& output, Settings& settings);

/// How the values of a view stand in a file: value in the file = factor * term + offset, scene-linear.
struct ShownView
{
    Image picture;
    ViewScale scale;
};

/// EXR and HDR hold the term itself; the others the term in its scale, so that it lies in [0, 1], without a tone curve.
ShownView showView(const View& view, const Image& drawn, bool sceneLinearFile);

Json viewAsJson(const Settings& settings, const ViewScale& scale);

} // namespace torrance
