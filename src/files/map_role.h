// What a picture of a material is of, told by its name.
#pragma once

#include <optional>
#include <string_view>

namespace torrance {

enum class MapRole
{
    color,
    roughness,
    metallic,
    normalGl, // +Y up
    normalDx, // +Y down
    occlusion,
    armPacked, // R occlusion, G roughness, B metallic
    opacity,
    emission,
    displacement,
};

/// For messages: "colour", "roughness", ...
std::string_view roleName(MapRole role);

/// By the last words of a file's name without its extension, in any case of letters; words that state a resolution, a
/// format or a depth behind them do not count. Nothing where they name no role.
std::optional<MapRole> mapRole(std::string_view stem);

} // namespace torrance
