#include "window/window_command.h"

#include "app/device_option.h"
#include "app/lit_scene.h"
#include "app/method_table_option.h"
#include "app/window_options.h"
#include "core/error.h"
#include "core/log.h"
#include "files/gltf_save.h"
#include "gpu/driver_environment.h"
#include "gpu/shader_folder.h"
#include "view/kept_settings.h"
#include "view/recovery.h"
#include "view/viewer.h"

namespace torrance {
namespace {

std::optional<Environment> load(const EnvironmentChoice& choice, const brdf::Preset& methods)
{
    if (choice.name == "none")
        return std::nullopt;
    return loadChosenEnvironment({.name = choice.name, .rotation = choice.rotation, .intensity = choice.intensity},
                                 methods);
}

void write(const std::string& file, Picture picture, const Settings& settings, const WriteSettings& curves)
{
    if (const View* view = settings.view)
        picture.color = showView(*view, picture.color, isSceneLinear(imageFormatOf(file))).picture;
    writePicture(file, picture.color, {}, curves);
}

void save(const SceneOptions& options, const SceneToSave& scene, const std::string& target)
{
    if (!options.primitive.empty())
        throw usageError("a shape comes from no file that its material could be saved to", "open a glTF file");
    const std::filesystem::path own = sceneFile(scene.input);
    const bool fromCopy = !scene.sourceCopy.empty();
    GltfSaveOptions how = {.load = loadOptions(options), .pictures = scene.pictures, .duplicateOf = scene.duplicateOf};
    if (fromCopy)
        how.load.readAs = own;
    for (const std::string& remark :
         saveGltf(fromCopy ? scene.sourceCopy : own, scene.original, scene.edited, target, how))
        logWarning(remark);
}

bool isGiven(const CameraOptions& camera)
{
    return !camera.orbit.empty() || !camera.target.empty() || !camera.position.empty() || camera.up ||
           camera.verticalFov || camera.margin;
}

ViewerHost makeHost(const WindowOptions& options, const GlobalOptions& global)
{
    ViewerHost host;
    host.settings = frameSettings(options.frame);
    chooseView(options.view, options.output, host.settings);
    if (!options.scene.files.empty() || !options.scene.primitive.empty())
        host.inputs = sceneInputs(options.scene);
    if (host.inputs.size() > 1)
        throw usageError("a window shows one scene, and " + std::to_string(host.inputs.size()) + " are named",
                         "name one; others can be dropped on the window");
    const brdf::Preset methods = host.settings.methods;
    host.loadScene = [&options, methods](const std::string& input, const std::stop_token& stop) {
        return loadLitScene(options.scene, options.light, methods, std::nullopt, input, stop);
    };
    host.loadEnvironment = [methods](const EnvironmentChoice& choice) { return load(choice, methods); };
    host.firstCamera = [&options](const Scene& scene, double aspect) {
        return chooseCamera(options.camera, scene, aspect);
    };
    host.writePicture = write;
    host.lampOf = presetLamp;
    host.saveScene = [&options](const SceneToSave& scene, const std::string& target) {
        save(options.scene, scene, target);
    };
    host.methodTable = [&options](const gpu::DeviceDescription& device) {
        return loadMethodTable(options.methods, device, true).table;
    };
    host.choosesCamera = isGiven(options.camera);
    host.firstFileCamera = host.inputs.empty() ? -1 : cameraOptionsFor(options.camera, host.inputs.front()).index;
    host.sceneOptions = lastingArguments(options);
    host.environments.assign(builtInEnvironments().begin(), builtInEnvironments().end());
    host.environments.emplace_back("none");
    host.write = writeSettings(options.output, methods);
    host.environment = {.name = environmentName(options.environment, methods),
                        .rotation = options.environment.rotation,
                        .intensity = options.environment.intensity};
    if (host.environment.name != "none")
        load(host.environment, methods); // what is wrong with its options is said before a window opens
    host.windowSize = chosenSize(options.frame.picture);
    host.choosesSize = choosesSize(options);
    host.deviceChoice = options.device;
    host.validation = options.validation;
    host.watch = options.watch;
    host.cacheFolder = cacheFolder(global);
    host.configFolder = userConfigFolder();
    host.stateFolder = userStateFolder();
    host.shaderFolder = gpu::shaderFolder();
    host.report = options.report;
    return host;
}

ExitCode run(const WindowOptions& options, const GlobalOptions& global)
{
    gpu::prepareDriverEnvironment(cacheFolder(global));
    Viewer viewer(makeHost(options, global));
    viewer.run();
    const std::vector<std::string> messages = viewer.validationMessages();
    for (const std::string& message : messages)
        logError(message);
    return messages.empty() ? ExitCode::success : ExitCode::checkFailed;
}

} // namespace

Command windowCommand()
{
    return makeCommand<WindowOptions>("view", "Show a scene in a window", declareWindowOptions, run);
}

} // namespace torrance
