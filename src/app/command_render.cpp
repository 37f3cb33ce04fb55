#include "app/command_render.h"

#include "app/certify.h"
#include "app/device_option.h"
#include "app/layer_output.h"
#include "app/lit_scene.h"
#include "app/method_table_option.h"
#include "app/phases.h"
#include "app/progress_line.h"
#include "app/render_options.h"
#include "core/error.h"
#include "core/log.h"
#include "core/read_file.h"
#include "core/standard_output.h"
#include "files/json_write.h"
#include "gpu/shader_folder.h"
#include "passes/renderer.h"
#include "prepare/kept_textures.h"
#include "study/transport_part.h"

#include <algorithm>
#include <fmt/format.h>
#include <future>

namespace torrance {
namespace {

using Options = RenderOptions;

// What all pictures of one run share.
struct Session
{
    const Options& options;
    bool resultOnStandardOutput; // picture or JSON: nothing else may go there
    Phases phases;               // before what is timed
    bool outside = false;        // some picture is not within the tolerance
    std::size_t picturesDecoded = 0;
    Settings settings;
    std::optional<CertificateRequest> certify; // a tolerance asks for it, too
    std::optional<Tolerance> tolerance;
    std::optional<NamedMethodTable> table; // where there is a tolerance
    std::optional<Environment> environment;
    KeptTextures keptTextures;
    std::optional<LoadedScene> first; // of the first input, loaded while the device is opened
    gpu::Device device;
    gpu::ShaderLibrary shaders;
    Renderer renderer;

    Session(const Options& o, const GlobalOptions& global, const std::string& firstInput)
        : Session(o, global, firstInput, renderSettings(o), startOpeningDevice(o.device, global))
    {
    }

    LoadedScene load(const std::string& input)
    {
        KnownImages known;
        if (!certify && !tolerance) // what is certified is compared with the texels
            known = [this](const ContentHash& encoded) {
                const auto picture = keptTextures.find(encoded);
                return picture ? std::optional(picture->image) : std::nullopt;
            };
        return counted(phases.time("load", [&] {
            return loadLitScene(options.scene, options.light, settings.methods, environment, input, {}, known);
        }));
    }

    /// Once more, with all its texels.
    LoadedScene loadWhole(const std::string& input)
    {
        return counted(phases.time("load", [&] {
            return buildLitScene(options.scene, options.light, settings.methods, environment, input, {},
                                 [](const ContentHash&) { return std::nullopt; });
        }));
    }

private:
    LoadedScene counted(LoadedScene loaded)
    {
        picturesDecoded += static_cast<std::size_t>(std::ranges::count_if(
            loaded.scene.images, [](const TextureImage& image) { return !image.texels.empty(); }));
        return loaded;
    }

    Session(const Options& o, const GlobalOptions& global, const std::string& firstInput, Settings s,
            std::future<gpu::Device> opening)
        : options(o), resultOnStandardOutput(o.output.pattern == "-" || global.json == "-"), settings(std::move(s)),
          certify(chosenCertificate(o.certify)), tolerance(chosenTolerance(o.tolerance)),
          environment(
              phases.time("environment", [&] { return loadChosenEnvironment(o.environment, settings.methods); })),
          keptTextures(cacheFolder(global)), first(load(firstInput)),
          device(phases.time("device", [&] { return finishOpeningDevice(std::move(opening)); })),
          shaders(gpu::shaderFolder(), cacheFolder(global)), renderer(device, shaders, cacheFolder(global))
    {
        if (!tolerance)
            return;
        if (!certify)
            certify.emplace();
        table = loadMethodTable(o.tolerance.methods, device.description, true);
    }
};

// To standard output, unless a result goes there.
void sayBeside(const Session& session, const std::string& text)
{
    session.resultOnStandardOutput ? logInfo(text) : writeStandardOutput(text);
}

/// What was drawn, and what it is worth.
struct Certified
{
    Certificate certificate;
    CertifiedPicture picture;
};

/// What the scene's file asks for and the renderer leaves out; what happens to a picture after the comparison.
void addUnvouched(const SceneFacts& facts, const std::string& output, std::vector<std::string>& effects)
{
    for (const ExtensionFact& extension : facts.extensions)
        if (!extension.supported)
            effects.push_back("surface: " + oneLine(extension.name) + ", which is left out");
    if (facts.animations.count() > 0)
        effects.emplace_back("surface: animations, which are not played");
    if (!isSceneLinear(imageFormatOf(output)))
        effects.emplace_back("display: tone curve and encoding, which come after the comparison");
}

/// A picture as the device wrote it, and how it came about.
struct Drawn
{
    Settings settings;
    ShadingPlan plan;
    Picture picture;
    std::optional<Certified> certified;
    std::optional<ToleranceResult> tolerance;
};

Drawn drawOnce(Session& session, const std::string& input, LoadedScene& loaded, const Camera& camera,
               const Settings& settings, std::span<const PixelBox> only = {})
{
    Drawn drawn;
    drawn.settings = settings;
    drawn.plan = session.phases.time("plan", [&] {
        return makePlan(loaded.scene, texelFacts(loaded.scene, loaded.encodedImages, session.keptTextures), settings);
    });
    TexelsRead freeTexels;
    if (!session.certify)
        freeTexels = [&](int image) {
            std::vector<std::byte>().swap(loaded.scene.images[static_cast<std::size_t>(image)].texels);
        };
    const DeviceScene deviceScene = session.phases.time("upload", [&] {
        return session.renderer.upload(loaded.scene, drawn.plan, &camera, freeTexels,
                                       {&session.keptTextures, loaded.encodedImages});
    });
    ProgressLine progress(input);
    drawn.picture = session.phases.time("draw", [&] {
        return session.renderer.render(
            deviceScene, camera, [&](int done, int all) { progress.show(done, all); }, only);
    });
    progress.clear();
    return drawn;
}

std::vector<brdf::Slot> slotsAskedFor(const FrameOptions& options)
{
    std::vector<brdf::Slot> slots;
    for (const auto& [slot, id] : options.methods.overrides)
        if (!id.empty())
            slots.push_back(slot);
    return slots;
}

Drawn drawWithinTolerance(Session& session, const std::string& input, LoadedScene& loaded, const Camera& camera)
{
    Drawn drawn;
    const ToleranceTask task = {.scene = loaded.scene,
                                .camera = camera,
                                .asked = session.settings,
                                .table = session.table->table,
                                .tolerance = *session.tolerance,
                                .fixed = slotsAskedFor(session.options.frame),
                                .request = *session.certify};
    ToleranceResult result =
        drawWithin(task, [&](const Settings& settings, std::span<const PixelBox> only) -> const Image& {
            drawn = drawOnce(session, input, loaded, camera, settings, only);
            return drawn.picture.color;
        });
    drawn.certified.emplace().certificate = result.certificate;
    drawn.tolerance = std::move(result);
    return drawn;
}

void describeCertified(Session& session, const std::string& input, const std::string& output, const LoadedScene& loaded,
                       const Camera& camera, Drawn& drawn)
{
    Certified& certified = *drawn.certified;
    if (certified.certificate.covered == 0)
        throw usageError("--certify: no surface is seen in the picture of " + input + ", and nothing can be compared",
                         "move the camera, or leave out --certify");
    addUnvouched(loaded.facts, output, certified.certificate.unvouched);
    certified.picture = describePicture(session.options, input, output, loaded.scene, camera, drawn.plan);
    certified.picture.device = session.device.description.name;
    certified.picture.driver = session.device.description.driverVersion;
    if (drawn.tolerance) {
        certified.picture.arguments = argumentsFound(std::move(certified.picture.arguments), *drawn.tolerance);
        certified.picture.tolerance = toleranceJson(*drawn.tolerance, session.table->hash);
    }
}

Json certifiedJson(const Drawn& drawn, const std::string& output)
{
    return certificateJson(drawn.certified->certificate, drawn.certified->picture, drawn.settings,
                           imageFormatOf(output) == ImageFormat::exr);
}

/// Beside a picture that has been written.
std::string writeCertificate(Drawn& drawn, const Session& session, const std::string& output)
{
    Certified& certified = *drawn.certified;
    if (imageFormatOf(output) != ImageFormat::exr)
        certified.picture.hash = hashBytes(readFile(output)).hex();
    const std::string file = certificateFile(output);
    writeJson(file, certifiedJson(drawn, output));
    sayBeside(session, output + ": " + certificateLine(certified.certificate) + "\n");
    return file;
}

Json drawLoaded(Session& session, const std::string& input, const std::string& output, LoadedScene loaded)
{
    Phases& phases = session.phases;
    const Scene& scene = loaded.scene;
    const double aspect = double(session.settings.width) / session.settings.height;
    const Camera camera = chooseCamera(cameraOptionsFor(session.options.camera, input), scene, aspect);
    if (session.certify)
        requireCertifiable(scene, session.settings);
    if (session.certify && session.certify->transport)
        requireTraceable(session.settings);
    Drawn drawn = session.tolerance ? drawWithinTolerance(session, input, loaded, camera)
                                    : drawOnce(session, input, loaded, camera, session.settings);
    if (session.options.explain)
        sayBeside(session, explain(drawn.plan) + (drawn.tolerance ? toleranceText(*drawn.tolerance) : ""));
    if (session.certify && !session.tolerance)
        drawn.certified.emplace().certificate = phases.time(
            "certify", [&] { return certify(scene, camera, session.settings, drawn.picture.color, *session.certify); });
    if (drawn.certified)
        describeCertified(session, input, output, loaded, camera, drawn);
    Picture& picture = drawn.picture;
    WriteSettings write = writeSettings(session.options.output, session.settings.methods);
    ViewScale viewScale;
    if (const View* view = session.settings.view) {
        ShownView shown = showView(*view, picture.color, isSceneLinear(imageFormatOf(output)));
        picture.color = std::move(shown.picture);
        viewScale = shown.scale;
        write.tone = findToneCurve("none");
        sayBeside(session, fmt::format("{}: {} * {} + {}\n", output, viewScale.factor, view->id, viewScale.offset));
    }
    if (drawn.certified && imageFormatOf(output) == ImageFormat::exr) {
        drawn.certified->picture.hash = pixelHash(picture.color).hex();
        write.attributes[kCertificateAttribute] = jsonText(certifiedJson(drawn, output));
    }
    auto files = phases.time("write", [&] { return writeWithLayers(output, picture, session.options.layers, write); });
    if (drawn.certified)
        files.push_back(writeCertificate(drawn, session, output));
    Json::Array written(files.begin(), files.end());
    Json::Object result = {{"input", input},
                           {"output", output},
                           {"files", written},
                           {"width", session.settings.width},
                           {"height", session.settings.height},
                           {"samples", session.settings.samples},
                           {"triangles", loaded.facts.triangles},
                           {"warnings", Json::Array(loaded.warnings.begin(), loaded.warnings.end())}};
    if (drawn.certified)
        result.emplace_back("certificate", certifiedJson(drawn, output));
    if (drawn.tolerance && !drawn.tolerance->holds) {
        session.outside = true;
        logError(output + ": not within the tolerance: " + drawn.tolerance->obstacle);
    }
    if (session.settings.view)
        result.emplace_back("view", viewAsJson(session.settings, viewScale));
    return result;
}

Json draw(Session& session, const std::string& input, const std::string& output)
{
    LoadedScene loaded = session.first ? std::move(*session.first) : session.load(input);
    session.first.reset();
    try {
        return drawLoaded(session, input, output, std::move(loaded));
    } catch (const TexelsMissing&) { // another size or camera reads other levels; or they made room for others
        return drawLoaded(session, input, output, session.loadWhole(input));
    }
}

ExitCode run(const Options& options, const GlobalOptions& global)
{
    const std::vector<std::string> inputs = sceneInputs(options.scene);
    const std::vector<std::string> outputs = outputNames(options.output, inputs);
    checkLayerNames(options.layers, layerNames());
    if (chosenCertificate(options.certify) || chosenTolerance(options.tolerance))
        std::ranges::for_each(outputs, checkCertifiedOutput);
    if (global.json == "-" && options.output.pattern == "-")
        throw usageError("--output and --json both name standard output", "give one of them a file");
    Session session(options, global, inputs.front());
    Json::Array pictures;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        pictures.push_back(draw(session, inputs[i], outputs[i]));
        if (outputs[i] != "-")
            logInfo("wrote " + outputs[i]);
    }
    reportPhases(session.phases);
    writeJson(global.json, Json::Object{{"pictures", pictures},
                                        {"device", session.device.description.name},
                                        {"driver", session.device.description.driverVersion},
                                        {"pipelines", session.renderer.pipelineCount()},
                                        {"shaders_compiled", session.shaders.compiledCount()},
                                        {"pictures_decoded", session.picturesDecoded},
                                        {"seconds", phasesAsJson(session.phases)}});
    return session.outside ? ExitCode::checkFailed : ExitCode::success;
}

} // namespace

Command renderCommand()
{
    return makeCommand<Options>("render", "Draw scenes to pictures", declareRenderOptions, run);
}

} // namespace torrance
