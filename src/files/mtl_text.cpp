#include "files/mtl_text.h"

#include "files/text_lines.h"

#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace torrance {
namespace {

enum class Kind
{
    color,   // r [g b]
    scalar,  // one number
    texture, // [options] name
    unused,  // means nothing to a physically based renderer
    undrawn, // something that is seen, but not drawn
};

struct Key
{
    std::string_view spelling; // in the file, in any case of letters
    Kind kind;
    std::string_view canonical = {}; // where it differs
};

constexpr auto kKeys = std::to_array<Key>({
    {"Kd", Kind::color},          {"Ks", Kind::color},
    {"Ke", Kind::color},          {"Ns", Kind::scalar},
    {"Ni", Kind::scalar},         {"d", Kind::scalar},
    {"Tr", Kind::scalar},         {"illum", Kind::scalar},
    {"Pr", Kind::scalar},         {"Pm", Kind::scalar},
    {"Ps", Kind::scalar},         {"Pc", Kind::scalar},
    {"Pcr", Kind::scalar},        {"aniso", Kind::scalar},
    {"anisor", Kind::scalar},     {"map_Kd", Kind::texture},
    {"map_Ks", Kind::texture},    {"map_Ns", Kind::texture},
    {"map_Ke", Kind::texture},    {"map_d", Kind::texture},
    {"map_bump", Kind::texture},  {"bump", Kind::texture, "map_bump"},
    {"norm", Kind::texture},      {"map_Kn", Kind::texture, "norm"},
    {"map_Pr", Kind::texture},    {"map_Pm", Kind::texture},
    {"map_Ps", Kind::texture},    {"Ka", Kind::unused}, // ambient light comes from the environment
    {"map_Ka", Kind::unused},     {"sharpness", Kind::unused},
    {"map_aat", Kind::unused},    {"Tf", Kind::undrawn},
    {"Kt", Kind::undrawn},        {"map_Tr", Kind::undrawn},
    {"map_Pc", Kind::undrawn},    {"map_Pcr", Kind::undrawn},
    {"map_aniso", Kind::undrawn}, {"disp", Kind::undrawn},
    {"map_disp", Kind::undrawn},  {"decal", Kind::undrawn},
    {"refl", Kind::undrawn},      {"map_refl", Kind::undrawn},
});

struct Option
{
    std::string_view name;
    std::size_t numbers;             // 0: a word follows
    std::array<const char*, 3> rest; // numbers that may be left out
};

constexpr auto kOptions = std::to_array<Option>({
    {"-s", 3, {"1", "1", "1"}},
    {"-o", 3, {"0", "0", "0"}},
    {"-t", 3, {"0", "0", "0"}},
    {"-mm", 2, {"0", "1", ""}},
    {"-bm", 1, {"1", "", ""}},
    {"-boost", 1, {"1", "", ""}},
    {"-texres", 1, {"-1", "", ""}},
    {"-clamp", 0, {}},
    {"-blendu", 0, {}},
    {"-blendv", 0, {}},
    {"-imfchan", 0, {}},
    {"-type", 0, {}},
    {"-colorspace", 0, {}},
});

bool sameWord(std::string_view a, std::string_view b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
        return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
    });
}

class MtlTextReader
{
public:
    explicit MtlTextReader(LoadReport& messages) : report(messages) {}

    MtlText read(std::string_view text)
    {
        TextLines lines(text);
        while (const auto next = lines.next()) {
            line = next->number;
            std::string_view rest = next->text;
            const std::string_view word = takeWord(rest);
            if (sameWord(word, "newmtl"))
                startMaterial(rest);
            else if (!result.materials.empty())
                readValue(word, rest);
        }
        finishMaterial();
        return std::move(result);
    }

private:
    [[noreturn]] void fail(const std::string& problem, const char* remedy = kRepair) const
    {
        report.fail("line " + std::to_string(line), problem, remedy);
    }

    void startMaterial(std::string_view name)
    {
        if (name.empty())
            fail("newmtl names no material", "give it a name");
        finishMaterial();
        result.statements += "newmtl " + std::to_string(result.materials.size()) + "\n";
        result.materials.push_back({std::string(name), {}});
    }

    /// A key that is stated twice is written once, or options of the first would stay with the second.
    void finishMaterial()
    {
        for (const auto& [key, value] : statements) {
            result.statements += key + " " + value + "\n";
            result.materials.back().keys.insert(key);
        }
        statements.clear();
    }

    void readValue(std::string_view word, std::string_view rest)
    {
        const auto key =
            std::find_if(kKeys.begin(), kKeys.end(), [&](const Key& k) { return sameWord(k.spelling, word); });
        const std::string item = "material " + result.materials.back().name;
        if (key == kKeys.end())
            return report.warn(item, "has the unknown key " + std::string(word) + ", which is passed over");
        if (key->kind == Kind::undrawn)
            return report.warn(item, "has " + std::string(key->spelling) + ", which is not drawn");
        if (key->kind == Kind::unused)
            return;
        const std::string canonical(key->canonical.empty() ? key->spelling : key->canonical);
        if (key->kind == Kind::texture)
            readTexture(canonical, rest);
        else
            readNumbers(canonical, rest, key->kind == Kind::color);
    }

    std::string checkedNumber(std::string_view word)
    {
        const std::optional<double> number = numberOf(word);
        if (!number)
            fail("\"" + std::string(word.substr(0, 40)) + "\" is no number");
        if (std::abs(*number) <= std::numeric_limits<float>::max())
            return std::string(word);
        ++report.nonFiniteNumbers;
        return "0";
    }

    void readNumbers(const std::string& key, std::string_view rest, bool isColor)
    {
        std::string_view word = takeWord(rest);
        const std::string item = "material " + result.materials.back().name;
        if (isColor && (sameWord(word, "spectral") || sameWord(word, "xyz")))
            return report.warn(item,
                               "has " + key + " as " + std::string(word) + ", which is not supported: it is left out");
        if (key == "d" && sameWord(word, "-halo")) {
            report.warn(item, "has d -halo, whose change with the angle is not drawn");
            word = takeWord(rest);
        }
        const std::string first = checkedNumber(word);
        std::string values = first;
        if (isColor) // one number stands for all three
            for (int i = 0; i < 2; ++i)
                values += " " + (rest.empty() ? first : checkedNumber(takeWord(rest)));
        statements[key] = values;
    }

    void readTexture(const std::string& key, std::string_view rest)
    {
        std::string value;
        while (rest.starts_with('-'))
            readOption(takeWord(rest), rest, value);
        if (rest.empty())
            fail(key + " names no file", "give it the name of a picture");
        statements[key] = value + std::string(rest);
    }

    void readOption(std::string_view name, std::string_view& rest, std::string& value)
    {
        const auto option =
            std::find_if(kOptions.begin(), kOptions.end(), [&](const Option& o) { return o.name == name; });
        if (option == kOptions.end())
            fail("\"" + std::string(name.substr(0, 40)) + "\" is no option of a map",
                 "remove it, or rename the picture if that is its name");
        (value += name) += ' ';
        if (option->numbers == 0)
            (value += takeWord(rest)) += ' ';
        for (std::size_t i = 0; i < option->numbers; ++i) {
            std::string_view ahead = rest;
            const std::string_view word = takeWord(ahead);
            const bool isNumber = numberOf(word).has_value() && !ahead.empty(); // the last word is the file's name
            (value += isNumber ? checkedNumber(word) : std::string(option->rest[i])) += ' ';
            rest = isNumber ? ahead : rest;
        }
    }

    LoadReport& report;
    MtlText result;
    std::map<std::string, std::string> statements; // of the material that is read
    std::size_t line = 0;
};

} // namespace

MtlText readMtlText(std::string_view text, LoadReport& report)
{
    return MtlTextReader(report).read(text);
}

} // namespace torrance
