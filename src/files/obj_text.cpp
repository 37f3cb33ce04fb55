#include "files/obj_text.h"

#include "files/text_lines.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

namespace torrance {
namespace {

/// The elements that a corner names, in the order in which it names them.
enum Element
{
    position,
    uv,
    normal,
};
constexpr std::size_t kElements = 3;
constexpr std::array<const char*, kElements> kElementNames = {"v", "vt", "vn"};

/// Statements of the format that no triangle comes from: curves, surfaces, their parameters, hints for rendering.
constexpr auto kPassedOver = std::to_array<std::string_view>(
    {"bevel",  "bmat",   "bsp",   "bzp",       "c_interp", "call",     "cdc",        "cdp", "con",
     "cstype", "csh",    "ctech", "curv",      "curv2",    "d_interp", "deg",        "end", "hole",
     "lod",    "maplib", "mg",    "parm",      "res",      "scrv",     "shadow_obj", "sp",  "stech",
     "step",   "surf",   "t",     "trace_obj", "trim",     "usemap",   "vp",         "vw"});

class ObjTextReader
{
public:
    ObjTextReader(const SceneLimits& most, LoadReport& messages) : limits(most), report(messages) {}

    ObjText read(std::string_view text)
    {
        TextLines lines(text);
        while (const auto statement = lines.next())
            readStatement(*statement);
        checkHighest();
        reportUnknown();
        if (result.corners.empty())
            report.fail("", "holds no face", "check that it is an OBJ file with a mesh");
        result.positions = counts[position];
        return std::move(result);
    }

private:
    [[noreturn]] void fail(const std::string& problem, const char* remedy = kRepair) const
    {
        report.fail("line " + std::to_string(line), problem, remedy);
    }

    void readStatement(const TextLine& statement)
    {
        line = statement.number;
        std::string_view rest = statement.text;
        const std::string_view word = takeWord(rest);
        if (word == "v")
            readVector(position, rest, 3, 3);
        else if (word == "vt")
            readVector(uv, rest, 1, 2);
        else if (word == "vn")
            readVector(normal, rest, 3, 3);
        else if (word == "f" || word == "fo") // fo: the same, of older files
            readFace(rest);
        else if (word == "o")
            setShape(object = rest, "");
        else if (word == "g")
            setShape(object, rest == "default" ? std::string_view() : rest);
        else if (word == "s")
            readSmoothing(rest);
        else if (word == "usemtl")
            setMaterial(rest);
        else if (word == "mtllib")
            addLibrary(rest);
        else
            passOver(word);
    }

    /// x y z [w], x y z r g b, u [v [w]]: the numbers beyond `wanted` that mean something are a vertex's colour.
    void readVector(Element element, std::string_view rest, std::size_t least, std::size_t wanted)
    {
        constexpr std::size_t kWithColor = 6;
        constexpr std::size_t kMost = 8;
        std::array<std::string_view, kMost> words;
        std::size_t count = 0;
        while (!rest.empty() && count < kMost)
            words[count++] = checkedNumber(takeWord(rest));
        if (count < least)
            fail(std::string(kElementNames[element]) + " has " + std::to_string(count) + " numbers");
        if (++counts[element] > limits.vertices)
            fail("brings the file to more than " + std::to_string(limits.vertices) + " vertices", "split the model");
        const std::size_t kept = element == position && count == kWithColor ? count : std::min(count, wanted);
        result.geometry += kElementNames[element];
        for (std::size_t i = 0; i < kept; ++i)
            (result.geometry += ' ') += words[i];
        result.geometry += '\n';
    }

    std::string_view checkedNumber(std::string_view word)
    {
        const std::optional<double> number = torrance::numberOf(word);
        if (!number)
            fail("\"" + std::string(word.substr(0, 40)) + "\" is no number");
        if (std::abs(*number) <= std::numeric_limits<float>::max())
            return word;
        ++report.nonFiniteNumbers;
        return "0";
    }

    void readFace(std::string_view rest)
    {
        const std::size_t start = result.geometry.size();
        result.geometry += 'f';
        std::uint32_t corners = 0;
        for (; !rest.empty(); ++corners)
            addCorner(takeWord(rest));
        result.geometry += '\n';
        if (corners < 3) {
            report.warn("", "has faces of fewer than three corners, which are left out");
            result.geometry.resize(start);
            return;
        }
        cornerCount += corners;
        if (cornerCount > limits.indices)
            fail("brings the file to more than " + std::to_string(limits.indices) + " corners of faces",
                 "split the model");
        startRun();
        result.corners.push_back(corners);
    }

    /// v, v/vt, v//vn or v/vt/vn; what is left empty is not there.
    void addCorner(std::string_view word)
    {
        std::array<std::size_t, kElements> indices = {0, 0, 0};
        std::string_view rest = word;
        for (std::size_t element = 0; element < kElements; ++element) {
            const std::size_t slash = std::min(rest.find('/'), rest.size());
            if (slash > 0)
                indices[element] = indexOf(static_cast<Element>(element), rest.substr(0, slash));
            rest = rest.substr(std::min(slash + 1, rest.size()));
        }
        if (indices[position] == 0 || !rest.empty())
            fail("\"" + std::string(word.substr(0, 40)) + "\" is no corner of a face");
        (result.geometry += ' ') += std::to_string(indices[position]);
        if (indices[uv] != 0 || indices[normal] != 0)
            result.geometry += '/';
        if (indices[uv] != 0)
            result.geometry += std::to_string(indices[uv]);
        if (indices[normal] != 0)
            (result.geometry += '/') += std::to_string(indices[normal]);
    }

    /// From 1. Negative ones count back from the element read last.
    std::size_t indexOf(Element element, std::string_view word)
    {
        std::int64_t index = 0;
        const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), index);
        if (failure != std::errc() || end != word.data() + word.size() || index == 0)
            fail("\"" + std::string(word.substr(0, 40)) + "\" is no index");
        if (index < 0) {
            if (static_cast<std::uint64_t>(-(index + 1)) >= counts[element])
                fail("refers to " + std::string(kElementNames[element]) + " " + std::to_string(index) + ", of " +
                     std::to_string(counts[element]) + " so far");
            return counts[element] - static_cast<std::size_t>(-(index + 1));
        }
        if (static_cast<std::size_t>(index) > highest[element].index)
            highest[element] = {static_cast<std::size_t>(index), line};
        return static_cast<std::size_t>(index);
    }

    /// A face may name what comes after it, so that this is known at the end only.
    void checkHighest() const
    {
        for (std::size_t element = 0; element < kElements; ++element)
            if (highest[element].index > counts[element])
                report.fail("line " + std::to_string(highest[element].line),
                            "refers to " + std::string(kElementNames[element]) + " " +
                                std::to_string(highest[element].index) + " of " + std::to_string(counts[element]),
                            kRepair);
    }

    void setShape(std::string_view objectName, std::string_view groupName)
    {
        shapeName = std::string(objectName);
        if (!groupName.empty())
            shapeName += (shapeName.empty() ? "" : " ") + std::string(groupName);
        state.shape = kUntilAFace;
    }

    void setMaterial(std::string_view name)
    {
        materialName = std::string(name);
        state.material = name.empty() ? -1 : kUntilAFace;
    }

    void readSmoothing(std::string_view rest)
    {
        state.smoothing = 0;
        if (rest == "off" || rest.empty())
            return;
        if (rest == "on") {
            state.smoothing = 1;
            return;
        }
        const auto [end, failure] = std::from_chars(rest.data(), rest.data() + rest.size(), state.smoothing);
        if (failure != std::errc() || end != rest.data() + rest.size())
            fail("\"s " + std::string(rest.substr(0, 40)) + "\" is no smoothing group");
    }

    void addLibrary(std::string_view name)
    {
        if (name.empty())
            fail("mtllib names no file");
        if (std::find(result.libraries.begin(), result.libraries.end(), name) == result.libraries.end())
            result.libraries.emplace_back(name);
    }

    void startRun()
    {
        if (state.shape == kUntilAFace)
            state.shape = numberOfName(shapeName, shapeOfName, result.shapes);
        if (state.material == kUntilAFace)
            state.material = numberOfName(materialName, materialOfName, result.materials);
        const bool same = !result.runs.empty() && result.runs.back().shape == state.shape &&
                          result.runs.back().material == state.material &&
                          result.runs.back().smoothing == state.smoothing;
        if (same)
            return;
        result.runs.push_back(state);
        result.runs.back().firstFace = result.corners.size();
    }

    static int numberOfName(std::string_view name, std::map<std::string, int, std::less<>>& numbers,
                            std::vector<std::string>& names)
    {
        const auto known = numbers.find(name);
        if (known != numbers.end())
            return known->second;
        numbers.emplace(name, static_cast<int>(names.size()));
        names.emplace_back(name);
        return static_cast<int>(names.size()) - 1;
    }

    void passOver(std::string_view word)
    {
        if (word == "l" || word == "p")
            report.warn("", "has lines or points, which are left out");
        else if (std::find(kPassedOver.begin(), kPassedOver.end(), word) != kPassedOver.end())
            report.warn("", "has statements of the kind \"" + std::string(word) + "\", which are passed over");
        else if (unknown++ == 0)
            firstUnknown = line;
    }

    void reportUnknown()
    {
        if (unknown > 0)
            report.warn("line " + std::to_string(firstUnknown),
                        "is the first of " + std::to_string(unknown) + " lines that are no statements of OBJ");
    }

    /// What no face belongs to gets no number.
    static constexpr int kUntilAFace = -2;

    struct Highest
    {
        std::size_t index = 0;
        std::size_t line = 0;
    };

    const SceneLimits& limits;
    LoadReport& report;
    ObjText result;
    std::size_t line = 0;
    std::array<std::size_t, kElements> counts = {0, 0, 0};
    std::array<Highest, kElements> highest;
    std::size_t cornerCount = 0;
    std::size_t unknown = 0;
    std::size_t firstUnknown = 0;
    ObjRun state = {.firstFace = 0, .shape = kUntilAFace, .material = -1, .smoothing = 0};
    std::string object, shapeName, materialName;
    std::map<std::string, int, std::less<>> shapeOfName, materialOfName;
};

} // namespace

ObjText readObjText(std::string_view text, const SceneLimits& limits, LoadReport& report)
{
    return ObjTextReader(limits, report).read(text);
}

} // namespace torrance
