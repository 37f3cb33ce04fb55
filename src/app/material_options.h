// The material that a primitive or a file is drawn with, chosen on the command line.
#pragma once

#include "files/scene_file.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace torrance {

struct MaterialOptions
{
    std::string named;               // of namedMaterials; empty = none
    std::string maps;                // a folder; empty = none
    std::string baseColor;           // #RRGGBB (sRGB) or three linear numbers
    std::optional<double> metallic;  // 0 to 1, times the map where there is one
    std::optional<double> roughness; // perceptual, as metallic
};

void declareMaterialOptions(CLI::App& app, MaterialOptions& options);

/// Something was chosen, so that the materials of a file are replaced.
bool choosesMaterial(const MaterialOptions& options);

/// Gives everything in the scene one material: that of the maps, or a plain one, with the factors chosen. Warnings are
/// added to the scene's. Errors: of the maps (input), of the values (usage).
void applyMaterial(const MaterialOptions& options, LoadedScene& loaded);

} // namespace torrance
