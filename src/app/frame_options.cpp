#include "app/frame_options.h"

#include "app/material_method_option.h"
#include "app/option_value.h"
#include "brdf/environment.h"
#include "core/error.h"
#include "passes/surface_pass.h"

#include <CLI/CLI.hpp>

namespace torrance {
namespace {

constexpr int kMaxSamples = 4096;

bool isReconstructed(const FrameOptions& o)
{
    const auto chosen = o.methods.overrides.find(brdf::Slot::pixelSampling);
    return chosen != o.methods.overrides.end() && chosen->second == "reconstructed";
}

// Counted are the targets (colour, sum, depth, layers, G-buffer), each ordinary memory on a software driver, one copy
// for reading back and one for writing.
double bytesPerPixel(const FrameOptions& o, bool layers)
{
    const double colorTargets = (o.samples > 1 ? 2.0 : 1.0) + (layers ? double(kLayerTargets) : 0.0) +
                                (o.path == "deferred"                         ? double(kGBufferTargets)
                                 : o.path == "attributes" || o.path == "auto" ? 2.0
                                                                              : 0.0);
    return 16.0 * (colorTargets + 2.0) + 4.0 + (isReconstructed(o) ? 4.0 * 5.0 : 0.0); // depth of samples, and edges
}

std::optional<bool> cullingOf(const std::string& name)
{
    return name == "auto" ? std::nullopt : std::optional(name == "on");
}

std::optional<RenderPath> pathOf(const std::string& name)
{
    if (name == "auto")
        return std::nullopt;
    return name == "prepass"      ? RenderPath::prepass
           : name == "attributes" ? RenderPath::attributes
           : name == "deferred"   ? RenderPath::deferred
                                  : RenderPath::forward;
}

} // namespace

void declareFrameOptions(CLI::App& app, FrameOptions& o)
{
    declarePictureOptions(app, o.picture);
    app.add_option("--background-blur", o.backgroundBlur,
                   "See the environment behind the scene through a lobe of this roughness, 0 (default) to 1")
        ->group("Output")
        ->check(CLI::Range(0.0, 1.0));
    app.add_option("--samples", o.samples, "Samples per pixel, placed by the reconstruction filter (default 1)")
        ->group("Output")
        ->check(CLI::Range(1, kMaxSamples));
    addChoice(
        app, "--path", o.path, {"auto", "forward", "prepass", "attributes", "deferred"},
        "Shade surfaces as they are drawn, draw depth first, shade each pixel once from what was interpolated, or "
        "from a G-buffer of floats (default auto: what is fastest for the scene)")
        ->group("Methods");
    addChoice(app, "--triangle-culling", o.triangleCulling, {"auto", "on", "off"},
              "Leave out the triangles that show at no pixel's centre before the device draws them: the same picture "
              "(default auto: where a software device gains by it)")
        ->group("Methods");
    declareMethodOptions(app, o.methods);
    app.add_option(
           "--environment-samples", o.environmentSamples,
           "Directions per pixel and picture of the environment_specular methods that draw samples (default 64)")
        ->group("Methods")
        ->check(CLI::Range(1, kMostLightDirections));
    app.add_option("--light-samples", o.lightSamples,
                   "Directions per pixel, picture and light of --area-light sampled (default 64)")
        ->group("Methods")
        ->check(CLI::Range(1, kMostLightDirections));
    declareMaterialMethodOption(app, o.ofMaterials);
}

Settings frameSettings(const FrameOptions& o, bool layers)
{
    const ivec2 size = chosenSize(o.picture);
    checkMemory(o.picture, bytesPerPixel(o, layers));
    const Background background = chosenBackground(o.picture);
    if (o.backgroundBlur && background.kind != BackgroundKind::environment)
        throw usageError("--background-blur is of the environment, and another background was asked for",
                         "leave one of them out");
    const brdf::Preset methods = chooseMethods(o.methods);
    if (o.environmentSamples && !(methods.environmentSpecular && brdf::drawsSamples(*methods.environmentSpecular)))
        throw usageError("--environment-samples is for methods that draw samples, and the environment's is " +
                             std::string(methods.environmentSpecular ? methods.environmentSpecular->id : "none"),
                         "choose one with --environment-specular, such as vndf_bounded");
    if (o.lightSamples && methods.areaLight->id != "sampled")
        throw usageError("--light-samples is for --area-light sampled, and the method is " +
                             std::string(methods.areaLight->id),
                         "choose it, or leave the number out");
    Settings settings = {.methods = methods,
                         .width = size.x,
                         .height = size.y,
                         .samples = o.samples,
                         .environmentSamples = o.environmentSamples.value_or(Settings().environmentSamples),
                         .lightSamples = o.lightSamples.value_or(Settings().lightSamples),
                         .background = background.kind,
                         .backgroundColor = background.color,
                         .backgroundBlur = o.backgroundBlur.value_or(0.0),
                         .path = pathOf(o.path),
                         .triangleCulling = cullingOf(o.triangleCulling),
                         .layers = layers};
    settings.ofMaterials = chosenMaterialMethods(o.ofMaterials, settings);
    return settings;
}

} // namespace torrance
