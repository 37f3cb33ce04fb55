// --material-methods: how light is computed for single materials.
#pragma once

#include "plan/settings.h"

#include <map>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace torrance {

/// Each text is "NUMBER:NAME=VALUE,...": a number in Scene::materials, slots of kLightSlots and methods as on the
/// command line without dashes, or environment-samples and light-samples and how many.
void declareMaterialMethodOption(CLI::App& app, std::vector<std::string>& texts);

/// For Settings::ofMaterials; what a text leaves out is as `settings` have it for all. Error (usage) for a text that is
/// none, a material that is named twice, and what has no effect.
std::map<int, LightMethods> chosenMaterialMethods(const std::vector<std::string>& texts, const Settings& settings);

} // namespace torrance
