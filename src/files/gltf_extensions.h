// Which extensions of glTF are drawn.
#pragma once

#include "files/load_report.h"

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>

namespace torrance {

std::span<const std::string_view> supportedExtensions();
bool isSupportedExtension(std::string_view name);

/// The names in document["extensionsUsed"] or ["extensionsRequired"].
std::vector<std::string> extensionNames(const nlohmann::json& document, const char* array);

/// An Error (input) names each required extension that is not supported; each one merely used is a warning.
void checkExtensions(const nlohmann::json& document, LoadReport& report);

} // namespace torrance
