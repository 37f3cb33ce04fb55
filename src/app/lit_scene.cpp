#include "app/lit_scene.h"

#include "core/log.h"

namespace torrance {

LoadedScene buildLitScene(const SceneOptions& options, const LightOptions& light, const brdf::Preset& methods,
                          const std::optional<Environment>& environment, const std::string& input,
                          const std::stop_token& stop, const KnownImages& known)
{
    LoadedScene loaded = buildChosenScene(options, input, stop, known);
    addChosenLights(light, methods, loaded.scene);
    giveLightsTheirRadius(options, loaded.scene); // the command line's lights have one too
    loaded.scene.environment = environment;
    return loaded;
}

LoadedScene loadLitScene(const SceneOptions& options, const LightOptions& light, const brdf::Preset& methods,
                         const std::optional<Environment>& environment, const std::string& input,
                         const std::stop_token& stop, const KnownImages& known)
{
    LoadedScene loaded = buildLitScene(options, light, methods, environment, input, stop, known);
    for (const std::string& warning : loaded.warnings)
        logWarning(warning);
    return loaded;
}

} // namespace torrance
