#include "files/gltf_version.h"

#include "core/error.h"

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

namespace torrance {
namespace {

struct Version
{
    int major = 0;
    int minor = 0;
};

std::optional<int> numberOf(std::string_view text)
{
    int number = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    return failure == std::errc{} && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

Version versionOf(const nlohmann::json& asset, const char* property, const std::string& file)
{
    const auto found = asset.find(property);
    const std::string text = found != asset.end() && found->is_string() ? found->get<std::string>() : "";
    const std::size_t dot = text.find('.');
    const auto major = numberOf(text.substr(0, dot));
    const auto minor = dot == std::string::npos ? std::nullopt : numberOf(text.substr(dot + 1));
    if (!major || !minor)
        throw inputError(file, "/asset/" + std::string(property), "is not a version such as \"2.0\"",
                         "repair or export the file again");
    return {*major, *minor};
}

} // namespace

void checkVersion(const nlohmann::json& document, const std::string& file)
{
    const auto asset = document.is_object() ? document.find("asset") : document.end();
    if (asset == document.end() || !asset->is_object())
        throw inputError(file, "/asset", "is missing: this is not a glTF 2.0 document", "give a .glb or .gltf file");
    const Version version = versionOf(*asset, "version", file);
    const bool hasMinimum = asset->contains("minVersion");
    const Version least = hasMinimum ? versionOf(*asset, "minVersion", file) : Version{version.major, 0};
    if (least.major != 2 || least.minor > 0)
        throw inputError(file, hasMinimum ? "/asset/minVersion" : "/asset/version",
                         "needs glTF " + std::to_string(least.major) + "." + std::to_string(least.minor),
                         "only glTF 2.0 is read: convert the file");
}

} // namespace torrance
