#include "gpu/shader_source.h"

#include "core/error.h"

#include <fstream>
#include <sstream>
#include <string_view>
#include <vector>

namespace torrance::gpu {
namespace {

std::string readText(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw usageError(path.string() + ": the shader is not there", "install Torrance whole");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<std::string> includedNames(std::string_view text)
{
    std::vector<std::string> names;
    constexpr std::string_view kInclude = "#include \"";
    for (std::size_t at = text.find(kInclude); at != std::string_view::npos; at = text.find(kInclude, at + 1)) {
        const std::size_t first = at + kInclude.size();
        const std::size_t last = text.find('"', first);
        if (last != std::string_view::npos)
            names.emplace_back(text.substr(first, last - first));
    }
    return names;
}

} // namespace

ContentHash ShaderSource::hash() const
{
    ContentHasher hasher;
    hasher.add(entry);
    for (const auto& [name, text] : files)
        hasher.add(name).add(text);
    return hasher.finish();
}

ShaderSource gatherSource(const std::filesystem::path& root, const std::string& entry, const std::string& selected)
{
    ShaderSource source = {.entry = entry, .files = {}};
    std::vector<std::string> open = {entry};
    while (!open.empty()) {
        const std::string name = open.back();
        open.pop_back();
        if (source.files.contains(name))
            continue;
        // A name may stand under an #if for C++: glslang says so if it needs one that is not there.
        if (name != entry && name != kSelectedName && !std::filesystem::exists(root / name))
            continue;
        const std::string text = name == kSelectedName ? selected : readText(root / name);
        for (std::string& included : includedNames(text))
            open.push_back(std::move(included));
        source.files.emplace(name, text);
    }
    return source;
}

} // namespace torrance::gpu
