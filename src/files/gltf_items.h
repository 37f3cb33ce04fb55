// The arrays of a glTF document, present or not.
#pragma once

#include <nlohmann/json.hpp>

namespace torrance {

/// document["meshes"], or an empty array: an absent array of glTF is an empty one.
inline const nlohmann::json& itemsOf(const nlohmann::json& document, const char* array)
{
    static const nlohmann::json empty = nlohmann::json::array();
    const auto found = document.find(array);
    return found == document.end() ? empty : *found;
}

} // namespace torrance
