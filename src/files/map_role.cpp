#include "files/map_role.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

namespace torrance {
namespace {

struct Spelling
{
    std::string_view words; // joined, in small letters
    MapRole role;
};

constexpr auto kSpellings = std::to_array<Spelling>({
    {"color", MapRole::color},
    {"colour", MapRole::color},
    {"col", MapRole::color},
    {"albedo", MapRole::color},
    {"basecolor", MapRole::color},
    {"basecolour", MapRole::color},
    {"diff", MapRole::color},
    {"diffuse", MapRole::color},
    {"roughness", MapRole::roughness},
    {"rough", MapRole::roughness},
    {"metalness", MapRole::metallic},
    {"metallic", MapRole::metallic},
    {"metal", MapRole::metallic},
    {"normalgl", MapRole::normalGl},
    {"norgl", MapRole::normalGl},
    {"normalopengl", MapRole::normalGl},
    {"normal", MapRole::normalGl}, // as glTF has it, where nothing is said
    {"nor", MapRole::normalGl},
    {"nrm", MapRole::normalGl},
    {"normaldx", MapRole::normalDx},
    {"nordx", MapRole::normalDx},
    {"normaldirectx", MapRole::normalDx},
    {"ambientocclusion", MapRole::occlusion},
    {"occlusion", MapRole::occlusion},
    {"ao", MapRole::occlusion},
    {"arm", MapRole::armPacked},
    {"orm", MapRole::armPacked},
    {"opacity", MapRole::opacity},
    {"alpha", MapRole::opacity},
    {"emission", MapRole::emission},
    {"emissive", MapRole::emission},
    {"displacement", MapRole::displacement},
    {"disp", MapRole::displacement},
    {"height", MapRole::displacement},
});

std::vector<std::string> wordsOf(std::string_view stem)
{
    std::vector<std::string> words(1);
    for (const char c : stem) {
        if (std::isalnum(static_cast<unsigned char>(c)))
            words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!words.back().empty())
            words.emplace_back();
    }
    if (words.back().empty())
        words.pop_back();
    return words;
}

/// "1k", "16k", "2048", "png", "16bit": says how the picture is stored, not what it is of.
bool isStorage(const std::string& word)
{
    const std::size_t digits = std::min(word.find_first_not_of("0123456789"), word.size());
    const std::string rest = word.substr(digits);
    return (digits > 0 && (rest.empty() || rest == "k" || rest == "bit")) || rest == "png" || rest == "jpg" ||
           rest == "jpeg" || rest == "exr";
}

std::optional<MapRole> roleOfWords(std::string_view words)
{
    const auto found = std::find_if(kSpellings.begin(), kSpellings.end(),
                                    [&](const Spelling& spelling) { return spelling.words == words; });
    return found == kSpellings.end() ? std::nullopt : std::optional(found->role);
}

} // namespace

std::string_view roleName(MapRole role)
{
    constexpr std::array<std::string_view, 10> kNames = {"colour",
                                                         "roughness",
                                                         "metalness",
                                                         "normals (GL)",
                                                         "normals (DX)",
                                                         "occlusion",
                                                         "occlusion, roughness and metalness",
                                                         "opacity",
                                                         "emission",
                                                         "displacement"};
    return kNames[static_cast<std::size_t>(role)];
}

std::optional<MapRole> mapRole(std::string_view stem)
{
    std::vector<std::string> words = wordsOf(stem);
    while (!words.empty() && isStorage(words.back()))
        words.pop_back();
    if (words.empty())
        return std::nullopt;
    if (words.size() > 1)
        if (const auto role = roleOfWords(words[words.size() - 2] + words.back())) // "nor_gl", "base color"
            return role;
    return roleOfWords(words.back());
}

} // namespace torrance
