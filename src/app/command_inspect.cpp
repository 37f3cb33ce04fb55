#include "app/command_inspect.h"

#include "app/scene_input.h"
#include "core/log.h"
#include "core/standard_output.h"
#include "files/json_write.h"
#include "files/scene_file.h"
#include "scene/camera_fit.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <optional>

namespace torrance {
namespace {

/// A file that can be read has facts; one that can be drawn has a scene too, and otherwise an error.
struct Inspected
{
    std::string file;
    std::optional<SceneFacts> facts;
    std::optional<LoadedScene> loaded;
    std::optional<Error> error;
};

Inspected inspect(const std::string& file, const SceneOptions& options)
{
    Inspected result{file, {}, {}, {}};
    try {
        if (options.primitive.empty())
            result.facts = readFacts(sceneFile(file), loadOptions(options));
        result.loaded = buildChosenScene(options, file);
        giveLightsTheirRadius(options, result.loaded->scene);
        result.facts = result.loaded->facts;
    } catch (const Error& error) {
        result.error = error;
    }
    return result;
}

struct Counted
{
    const char* name; // in the plural
    const NamedItems SceneFacts::*items;
};

constexpr Counted kCounted[] = {
    {"scenes", &SceneFacts::scenes},         {"nodes", &SceneFacts::nodes},       {"meshes", &SceneFacts::meshes},
    {"materials", &SceneFacts::materials},   {"textures", &SceneFacts::textures}, {"images", &SceneFacts::images},
    {"cameras", &SceneFacts::cameras},       {"lights", &SceneFacts::lights},     {"skins", &SceneFacts::skins},
    {"animations", &SceneFacts::animations},
};

/// More names than this are cut off in the text; JSON has them all.
constexpr std::size_t kNamesShown = 8;

std::string namesText(const NamedItems& items)
{
    std::string text;
    std::size_t shown = 0;
    for (const std::string& name : items.names)
        if (!name.empty() && shown++ < kNamesShown)
            text += (text.empty() ? "  " : ", ") + name;
    return shown > kNamesShown ? text + fmt::format(", and {} more", shown - kNamesShown) : text;
}

std::string bytesText(std::uint64_t bytes)
{
    constexpr double kKilo = 1024.0;
    constexpr double kMega = kKilo * kKilo;
    const auto size = static_cast<double>(bytes);
    return size < kKilo   ? fmt::format("{} B", bytes)
           : size < kMega ? fmt::format("{:.1f} KiB", size / kKilo)
                          : fmt::format("{:.1f} MiB", size / kMega);
}

std::string extensionText(const ExtensionFact& extension)
{
    return fmt::format("  extension  {} ({}, {})\n", extension.name, extension.required ? "required" : "used",
                       extension.supported ? "supported" : "not supported");
}

std::string factsText(const SceneFacts& facts)
{
    std::string text =
        fmt::format("  {}{}{}\n", facts.container, facts.version.empty() ? "" : " of glTF " + facts.version,
                    facts.generator.empty() ? "" : ", made by " + facts.generator);
    if (!facts.copyright.empty())
        text += fmt::format("  copyright  {}\n", facts.copyright);
    for (const Counted& counted : kCounted) {
        const NamedItems& items = facts.*counted.items;
        if (items.count() > 0)
            text += fmt::format("  {:<10} {}{}\n", counted.name, items.count(), namesText(items));
    }
    text += fmt::format("  {:<10} {}\n", "primitives", facts.primitives);
    if (facts.accessors > 0)
        text += fmt::format("  {:<10} {}\n", "accessors", facts.accessors);
    for (const ExtensionFact& extension : facts.extensions)
        text += extensionText(extension);
    return text;
}

std::string imageText(const TextureImage& image)
{
    return fmt::format("  image      {} {} x {}, {} bit\n", image.name, image.width, image.height,
                       image.format == TexelFormat::rgba8 ? 8 : 16);
}

std::string drawnText(const LoadedScene& loaded)
{
    const SceneFacts& facts = loaded.facts;
    std::string text = fmt::format("  drawn      {}: {} instances, {} vertices, {} triangles, {} lines, {} points\n",
                                   facts.scene < 0 ? "everything" : fmt::format("scene {}", facts.scene),
                                   facts.instances, facts.vertices, facts.triangles, facts.lines, facts.points);
    if (facts.instances > 0) {
        const Bounds bounds = worldBounds(loaded.scene);
        text += fmt::format("  extent     {:.4g} x {:.4g} x {:.4g} m\n", bounds.max.x - bounds.min.x,
                            bounds.max.y - bounds.min.y, bounds.max.z - bounds.min.z);
    }
    text += fmt::format("  bytes      {} file, {} buffers, {} decoded texels\n", bytesText(facts.fileBytes),
                        bytesText(facts.bufferBytes), bytesText(facts.texelBytes));
    for (const TextureImage& image : loaded.scene.images)
        text += imageText(image);
    for (const std::string& warning : loaded.warnings)
        text += fmt::format("  warning    {}\n", warning);
    return text;
}

/// Line by line: what names a file holds must not break its own report.
std::string printable(const std::string& text)
{
    std::string lines;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        lines += oneLine(text.substr(start, end - start)) + "\n";
        start = end + 1;
    }
    return lines;
}

std::string text(const Inspected& inspected)
{
    if (!inspected.facts)
        return "";
    return inspected.file + "\n" + factsText(*inspected.facts) +
           (inspected.loaded ? drawnText(*inspected.loaded) : "  drawn      not: see the error\n");
}

Json toJson(const NamedItems& items)
{
    Json::Array names;
    for (const std::string& name : items.names)
        names.push_back(name);
    return names;
}

Json toJson(const ExtensionFact& extension)
{
    return Json::Object{{"name", extension.name}, {"required", extension.required}, {"supported", extension.supported}};
}

void addFacts(Json::Object& object, const SceneFacts& facts)
{
    object.emplace_back("container", facts.container);
    object.emplace_back("version", facts.version);
    object.emplace_back("generator", facts.generator);
    object.emplace_back("copyright", facts.copyright);
    object.emplace_back("fileBytes", facts.fileBytes);
    for (const Counted& counted : kCounted)
        object.emplace_back(counted.name, toJson(facts.*counted.items));
    object.emplace_back("primitives", facts.primitives);
    object.emplace_back("accessors", facts.accessors);
    object.emplace_back("morphTargets", facts.morphTargets);
    Json::Array extensions;
    for (const ExtensionFact& extension : facts.extensions)
        extensions.push_back(toJson(extension));
    object.emplace_back("extensions", std::move(extensions));
}

Json toJson(const dvec3& v)
{
    return Json::Array{v.x, v.y, v.z};
}

Json drawnJson(const LoadedScene& loaded)
{
    const SceneFacts& facts = loaded.facts;
    Json::Array images;
    for (const TextureImage& image : loaded.scene.images)
        images.push_back(Json::Object{{"name", image.name},
                                      {"width", image.width},
                                      {"height", image.height},
                                      {"bits", image.format == TexelFormat::rgba8 ? 8 : 16}});
    Json::Object object = {{"scene", facts.scene},
                           {"instances", facts.instances},
                           {"vertices", facts.vertices},
                           {"triangles", facts.triangles},
                           {"lines", facts.lines},
                           {"points", facts.points},
                           {"bufferBytes", facts.bufferBytes},
                           {"texelBytes", facts.texelBytes},
                           {"replacedNumbers", facts.replacedNumbers},
                           {"images", std::move(images)}};
    if (facts.instances > 0) {
        const Bounds bounds = worldBounds(loaded.scene);
        object.emplace_back("boundsMin", toJson(bounds.min));
        object.emplace_back("boundsMax", toJson(bounds.max));
    }
    return object;
}

Json toJson(const Inspected& inspected)
{
    Json::Object object = {{"file", inspected.file}};
    if (inspected.error)
        object.emplace_back("error", inspected.error->what());
    if (inspected.facts)
        addFacts(object, *inspected.facts);
    if (inspected.loaded) {
        object.emplace_back("drawn", drawnJson(*inspected.loaded));
        Json::Array warnings;
        for (const std::string& warning : inspected.loaded->warnings)
            warnings.push_back(warning);
        object.emplace_back("warnings", std::move(warnings));
    }
    return object;
}

/// Every file is looked at, whatever the others are; the last error decides the exit code.
ExitCode run(const SceneOptions& options, const GlobalOptions& global)
{
    ExitCode code = ExitCode::success;
    Json::Array files;
    for (const std::string& file : sceneInputs(options)) {
        const Inspected inspected = inspect(file, options);
        if (global.json != "-") // standard output holds one result
            writeStandardOutput(printable(text(inspected)));
        if (inspected.error) {
            logError(inspected.error->what());
            code = inspected.error->exitCode;
        }
        files.push_back(toJson(inspected));
    }
    if (!global.json.empty())
        writeJson(global.json, Json::Object{{"files", std::move(files)}});
    return code;
}

} // namespace

Command inspectCommand()
{
    return makeCommand<SceneOptions>("inspect", "Say what glTF and OBJ files hold and need", declareSceneOptions, run);
}

} // namespace torrance
