#include "app/command_render.h"

#include "app/certify.h"
#include "app/device_option.h"
#include "app/layer_output.h"
#include "app/lit_scene.h"
#include "app/phases.h"
#include "app/progress_line.h"
#include "app/render_options.h"
#include "core/data_folder.h"
#include "core/error.h"
#include "core/log.h"
#include "core/read_file.h"
#include "core/standard_output.h"
#include "files/json_write.h"
#include "passes/renderer.h"
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
    Settings settings;
    std::optional<CertificateRequest> certify;
    std::optional<Environment> environment;
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
        return phases.time(
            "load", [&] { return loadLitScene(options.scene, options.light, settings.methods, environment, input); });
    }

private:
    Session(const Options& o, const GlobalOptions& global, const std::string& firstInput, Settings s,
            std::future<gpu::Device> opening)
        : options(o), resultOnStandardOutput(o.output.pattern == "-" || global.json == "-"), settings(std::move(s)),
          certify(chosenCertificate(o.certify)),
          environment(
              phases.time("environment", [&] { return loadChosenEnvironment(o.environment, settings.methods); })),
          first(load(firstInput)),
          device(phases.time("device", [&] { return finishOpeningDevice(std::move(opening)); })),
          shaders(dataFolder() / "shaders", cacheFolder(global)), renderer(device, shaders, cacheFolder(global))
    {
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

Certified certifyDrawn(Session& session, const std::string& input, const std::string& output, const LoadedScene& loaded,
                       const Camera& camera, const ShadingPlan& plan, const Image& drawn)
{
    Certified certified;
    certified.certificate = certify(loaded.scene, camera, session.settings, drawn, *session.certify);
    if (certified.certificate.covered == 0)
        throw usageError("--certify: no surface is seen in the picture of " + input + ", and nothing can be compared",
                         "move the camera, or leave out --certify");
    addUnvouched(loaded.facts, output, certified.certificate.unvouched);
    certified.picture = describePicture(session.options, input, output, loaded.scene, camera, plan);
    certified.picture.device = session.device.description.name;
    certified.picture.driver = session.device.description.driverVersion;
    return certified;
}

Json certifiedJson(const Certified& certified, const Session& session, const std::string& output)
{
    return certificateJson(certified.certificate, certified.picture, session.settings,
                           imageFormatOf(output) == ImageFormat::exr);
}

/// Beside a picture that has been written.
std::string writeCertificate(Certified& certified, const Session& session, const std::string& output)
{
    if (imageFormatOf(output) != ImageFormat::exr)
        certified.picture.hash = hashBytes(readFile(output)).hex();
    const std::string file = certificateFile(output);
    writeJson(file, certifiedJson(certified, session, output));
    sayBeside(session, output + ": " + certificateLine(certified.certificate) + "\n");
    return file;
}

Json draw(Session& session, const std::string& input, const std::string& output)
{
    Phases& phases = session.phases;
    LoadedScene loaded = session.first ? std::move(*session.first) : session.load(input);
    session.first.reset();
    const Scene& scene = loaded.scene;
    const double aspect = double(session.settings.width) / session.settings.height;
    const Camera camera = chooseCamera(cameraOptionsFor(session.options.camera, input), scene, aspect);
    if (session.certify)
        requireCertifiable(scene, session.settings);
    if (session.certify && session.certify->transport)
        requireTraceable(session.settings);
    const ShadingPlan plan = phases.time("plan", [&] { return makePlan(scene, session.settings); });
    if (session.options.explain)
        sayBeside(session, explain(plan));
    const DeviceScene deviceScene =
        phases.time("upload", [&] { return session.renderer.upload(scene, plan, &camera); });
    if (!session.certify)
        for (TextureImage& image : loaded.scene.images)
            std::vector<std::byte>().swap(image.texels); // the device has them
    ProgressLine progress(input);
    Picture picture = phases.time("draw", [&] {
        return session.renderer.render(deviceScene, camera, [&](int done, int all) { progress.show(done, all); });
    });
    progress.clear();
    std::optional<Certified> certified;
    if (session.certify)
        certified = phases.time(
            "certify", [&] { return certifyDrawn(session, input, output, loaded, camera, plan, picture.color); });
    WriteSettings write = writeSettings(session.options.output, session.settings.methods);
    ViewScale viewScale;
    if (const View* view = session.settings.view) {
        ShownView shown = showView(*view, picture.color, isSceneLinear(imageFormatOf(output)));
        picture.color = std::move(shown.picture);
        viewScale = shown.scale;
        write.tone = findToneCurve("none");
        sayBeside(session, fmt::format("{}: {} * {} + {}\n", output, viewScale.factor, view->id, viewScale.offset));
    }
    if (certified && imageFormatOf(output) == ImageFormat::exr) {
        certified->picture.hash = pixelHash(picture.color).hex();
        write.attributes[kCertificateAttribute] = jsonText(certifiedJson(*certified, session, output));
    }
    auto files = phases.time("write", [&] { return writeWithLayers(output, picture, session.options.layers, write); });
    if (certified)
        files.push_back(writeCertificate(*certified, session, output));
    Json::Array written(files.begin(), files.end());
    Json::Object result = {{"input", input},
                           {"output", output},
                           {"files", written},
                           {"width", session.settings.width},
                           {"height", session.settings.height},
                           {"samples", session.settings.samples},
                           {"triangles", loaded.facts.triangles},
                           {"warnings", Json::Array(loaded.warnings.begin(), loaded.warnings.end())}};
    if (certified)
        result.emplace_back("certificate", certifiedJson(*certified, session, output));
    if (session.settings.view)
        result.emplace_back("view", viewAsJson(session.settings, viewScale));
    return result;
}

ExitCode run(const Options& options, const GlobalOptions& global)
{
    const std::vector<std::string> inputs = sceneInputs(options.scene);
    const std::vector<std::string> outputs = outputNames(options.output, inputs);
    checkLayerNames(options.layers, layerNames());
    if (chosenCertificate(options.certify))
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
                                        {"seconds", phasesAsJson(session.phases)}});
    return ExitCode::success;
}

} // namespace

Command renderCommand()
{
    return makeCommand<Options>("render", "Draw scenes to pictures", declareRenderOptions, run);
}

} // namespace torrance
