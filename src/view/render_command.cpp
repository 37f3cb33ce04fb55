#include "view/render_command.h"

#include "brdf/slot_option.h"
#include "image/tone_curves.h"
#include "plan/path_plan.h"

#include <filesystem>
#include <fmt/format.h>

namespace torrance {
namespace {

// Between single quotes a shell changes nothing but the quote itself.
std::string quoted(const std::string& argument)
{
    constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";
    if (!argument.empty() && argument.find_first_not_of(kPlain) == std::string::npos)
        return argument;
    std::string text = "'";
    for (const char c : argument)
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

void addCamera(const ViewerState& state, std::vector<std::string>& arguments)
{
    if (const auto* fitted = std::get_if<FittedView>(&state.view))
        arguments.push_back(fmt::format("--orbit={},{}", fitted->theta, fitted->phi));
    else if (const auto* file = std::get_if<FileView>(&state.view))
        arguments.push_back(fmt::format("--camera-index={}", file->index));
    else
        for (std::string& argument : cameraArguments(std::get<OrbitPose>(state.view)))
            arguments.push_back(std::move(argument));
}

void addLight(const ViewerState& state, std::vector<std::string>& arguments)
{
    const EnvironmentChoice& environment = state.edits().environment;
    arguments.push_back("--environment=" + environment.name);
    if (environment.name == "none")
        return;
    if (environment.rotation != 0.0)
        arguments.push_back(fmt::format("--environment-rotation={}", environment.rotation));
    if (environment.intensity != 1.0)
        arguments.push_back(fmt::format("--environment-intensity={}", environment.intensity));
}

void addMethods(const Settings& settings, std::vector<std::string>& arguments)
{
    const brdf::Preset& preset = *brdf::findPreset(settings.methods.id);
    if (preset.id != "standard")
        arguments.push_back("--preset=" + std::string(preset.id));
    for (const brdf::Slot slot : brdf::allSlots()) {
        if (slot == brdf::Slot::tone || slot == brdf::Slot::transfer || slot == brdf::Slot::model)
            continue;
        const brdf::Method* method = settings.methods[slot];
        if (method && method != preset[slot])
            arguments.push_back(brdf::slotOption(slot) + "=" + std::string(method->id));
    }
    const LightMethods light = lightMethodsOf(settings);
    if (drawsEnvironmentSamples(light) && settings.environmentSamples != Settings().environmentSamples)
        arguments.push_back(fmt::format("--{}={}", kEnvironmentSamplesName, settings.environmentSamples));
    if (drawsLightSamples(light) && settings.lightSamples != Settings().lightSamples)
        arguments.push_back(fmt::format("--{}={}", kLightSamplesName, settings.lightSamples));
    for (const auto& [material, own] : settings.ofMaterials)
        arguments.push_back("--material-methods=" + materialMethodsText(material, own));
    if (settings.path)
        arguments.push_back(std::string("--path=") + nameOf(*settings.path));
    if (settings.triangleCulling)
        arguments.push_back(std::string("--triangle-culling=") + (*settings.triangleCulling ? "on" : "off"));
    if (settings.view)
        arguments.push_back("--view=" + std::string(settings.view->id));
}

void addPicture(const ViewerState& state, std::vector<std::string>& arguments)
{
    const Settings& settings = state.settings;
    arguments.push_back(fmt::format("--resolution={}x{}", settings.width, settings.height));
    if (state.fileSamples != 1)
        arguments.push_back(fmt::format("--samples={}", state.fileSamples));
    if (settings.background == BackgroundKind::transparent)
        arguments.emplace_back("--no-background");
    else if (settings.background == BackgroundKind::color)
        arguments.push_back(fmt::format("--background={},{},{}", settings.backgroundColor.x, settings.backgroundColor.y,
                                        settings.backgroundColor.z));
    else if (settings.backgroundBlur > 0.0)
        arguments.push_back(fmt::format("--background-blur={}", settings.backgroundBlur));
    if (state.write.transfer->id != settings.methods.transfer)
        arguments.push_back("--transfer=" + std::string(state.write.transfer->id));
    if (settings.view)
        return; // a term has neither exposure nor tone curve
    if (state.write.exposure != 0.0)
        arguments.push_back(fmt::format("--exposure={}", state.write.exposure));
    if (state.write.tone->id != settings.methods.tone)
        arguments.push_back("--tone=" + std::string(state.write.tone->id));
}

// A preset's own lamp comes with the preset.
std::vector<Light> withoutLamp(std::vector<Light> lights, const std::optional<Light>& lamp)
{
    if (lamp)
        std::erase(lights, *lamp);
    return lights;
}

std::vector<std::string> lostOf(const ViewerState& state, const ViewerHost& host)
{
    std::vector<std::string> lost;
    if (state.history->isDirty())
        lost.emplace_back("materials");
    if (withoutLamp(state.history->now().lights, host.lampOf(state.settings.methods)) !=
        withoutLamp(state.history->loaded().lights, host.lampOf(host.settings.methods)))
        lost.emplace_back("lights");
    return lost;
}

} // namespace

std::vector<std::string> renderArguments(const ViewerState& state, const ViewerHost& host)
{
    std::vector<std::string> arguments = {state.scene->input};
    arguments.insert(arguments.end(), host.sceneOptions.begin(), host.sceneOptions.end());
    addCamera(state, arguments);
    addLight(state, arguments);
    addMethods(state.settings, arguments);
    addPicture(state, arguments);
    return arguments;
}

RenderCommand renderCommandOf(const ViewerState& state, const ViewerHost& host)
{
    RenderCommand command = {.text = "torrance render", .lost = lostOf(state, host)};
    for (const std::string& argument : renderArguments(state, host))
        command.text += " " + quoted(argument);
    command.text += " -o " + quoted(std::filesystem::path(state.scene->input).stem().string() + ".png");
    return command;
}

} // namespace torrance
