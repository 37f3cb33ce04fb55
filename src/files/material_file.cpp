#include "files/material_file.h"

#include "core/atomic_write.h"
#include "core/error.h"
#include "files/gltf_extensions.h"
#include "files/gltf_extensions_used.h"
#include "files/gltf_items.h"
#include "files/gltf_material_write.h"
#include "files/gltf_materials.h"
#include "files/gltf_model.h"
#include "files/gltf_open.h"
#include "files/json_read.h"
#include "files/material_difference.h"

namespace torrance {
namespace {

/// Of what asset/extras says, raised when a file written today would be misread.
constexpr int kVersion = 1;
constexpr const char* kVersionKey = "torranceMaterial";

/// Without textures, each named in a warning.
Material withoutTextures(Material material, LoadReport& report)
{
    for (const auto& [name, use] : kTextureUses)
        if ((material.*use).used()) {
            report.warn(name, "is left out: a material file holds no textures");
            material.*use = TextureUse{};
        }
    const Material plain;
    if (material.normalScale != plain.normalScale)
        report.warn("normalTexture/scale", "is left out with its texture");
    if (material.occlusionStrength != plain.occlusionStrength)
        report.warn("occlusionTexture/strength", "is left out with its texture");
    material.normalScale = plain.normalScale;
    material.occlusionStrength = plain.occlusionStrength;
    return material;
}

OrderedJson documentOf(const Material& material)
{
    OrderedJson json = OrderedJson::object();
    writeMaterial(json, Material{}, material);
    OrderedJson document;
    document["asset"] = {{"version", "2.0"}, {"generator", "Torrance"}, {"extras", {{kVersionKey, kVersion}}}};
    document["materials"] = OrderedJson::array({std::move(json)});
    updateExtensionLists(document, {});
    return document;
}

/// checkSchema takes extras away, so that the version is looked up in the text.
void checkMaterialVersion(const OpenedGltf& opened, const std::string& file)
{
    const nlohmann::json document = readJson(opened.container.json, file);
    const nlohmann::json::json_pointer place = nlohmann::json::json_pointer("/asset/extras") / kVersionKey;
    if (!document.contains(place))
        return;
    const nlohmann::json& version = document[place];
    if (!version.is_number_integer() || version < 1 || version > kVersion)
        throw inputError(file, place.to_string(), "is not a version from 1 to " + std::to_string(kVersion),
                         "save the material again with this version of the program");
}

Material readOne(const std::filesystem::path& path, LoadReport& report)
{
    const OpenedGltf opened = openGltf(path, report.file);
    checkMaterialVersion(opened, report.file);
    checkExtensions(opened.document, report);
    const std::size_t count = itemsOf(opened.document, "materials").size();
    if (count != 1)
        report.fail("/materials", "holds " + std::to_string(count) + " materials where one is due",
                    "save the material to a file of its own");
    return readMaterial(readModel(opened.document, report), 0, report).material;
}

/// Of what was just written: a number that JSON cannot hold is another number.
Material readBack(const std::filesystem::path& path)
{
    LoadReport report;
    report.file = path.string();
    try {
        return readOne(path, report);
    } catch (const Error& failure) {
        throw writeError(report.file, "would not load, and nothing was written (" + std::string(failure.what()) + ")",
                         "set every factor to a number");
    }
}

} // namespace

std::vector<std::string> saveMaterial(const Material& material, const std::filesystem::path& path)
{
    LoadReport report;
    report.file = path.string();
    const Material stored = withoutTextures(material, report);
    constexpr const char* kIndentation = "{\n  \"";
    const std::string text = orderedJsonText(documentOf(stored), kIndentation) + "\n";
    writeFile(path, std::as_bytes(std::span(text)), [&](const std::filesystem::path& written) {
        const std::string field = differingField(readBack(written), stored);
        if (!field.empty())
            throw writeError(report.file, field + " would read back otherwise, and nothing was written",
                             "set it to what glTF can hold");
    });
    return report.warnings;
}

LoadedMaterial loadMaterial(const std::filesystem::path& path)
{
    LoadReport report;
    report.file = path.string();
    try {
        const Material material = withoutTextures(readOne(path, report), report);
        return {material, std::move(report.warnings)};
    } catch (const Error&) {
        throw;
    } catch (const std::exception& failure) // of the libraries behind us, on what no check of ours foresaw
    {
        throw inputError(report.file, "", failure.what(), kRepair);
    }
}

} // namespace torrance
