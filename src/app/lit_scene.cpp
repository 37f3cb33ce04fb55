#include "app/lit_scene.h"

namespace torrance {

LoadedScene loadLitScene(const SceneOptions& options, const LightOptions& light, const brdf::Preset& methods,
                         const std::optional<Environment>& environment, const std::string& input,
                         const std::stop_token& stop)
{
    LoadedScene loaded = loadChosenScene(options, input, stop);
    addChosenLights(light, methods, loaded.scene);
    giveLightsTheirRadius(options, loaded.scene); // the command line's lights have one too
    loaded.scene.environment = environment;
    return loaded;
}

} // namespace torrance
