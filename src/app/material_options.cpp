#include "app/material_options.h"

#include "app/option_value.h"
#include "files/map_folder.h"
#include "scene/named_material.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace torrance {
namespace {

// What a shape is where nothing is chosen: a light grey that is neither smooth nor rough.
constexpr double kBaseColor = 0.8, kRoughness = 0.5;

dvec3 parseBaseColor(const std::string& text)
{
    if (const auto color = parseHexColor(text))
        return *color;
    const std::vector<double> numbers = parseNumbers("--base-color", text, 3, 3);
    if (std::any_of(numbers.begin(), numbers.end(), [](double n) { return n < 0.0 || n > 1.0; }))
        throw usageError("--base-color " + text + ": numbers must lie between 0 and 1", "a surface reflects no more");
    return {numbers[0], numbers[1], numbers[2]};
}

double checkedFactor(const char* option, double value)
{
    if (!(value >= 0.0 && value <= 1.0))
        throw usageError(std::string(option) + " must lie between 0 and 1", "0.5 lies in the middle");
    return value;
}

Material mapsMaterial(const MaterialOptions& options, LoadedScene& loaded)
{
    LoadReport report;
    report.file = options.maps;
    const MapFolderNeeds needs = {.color = options.baseColor.empty(), .roughness = !options.roughness};
    const Material material = readMapFolder(options.maps, needs, SceneLimits{}, loaded.scene, report);
    loaded.warnings.insert(loaded.warnings.end(), report.warnings.begin(), report.warnings.end());
    return material;
}

Material startingMaterial(const MaterialOptions& options, LoadedScene& loaded)
{
    if (!options.maps.empty())
        return mapsMaterial(options, loaded);
    Material material;
    if (options.named.empty()) {
        material.baseColorFactor = dvec4(dvec3(kBaseColor), 1.0);
        material.metallicFactor = 0.0;
    } else
        material = materialOf(*findNamedMaterial(options.named));
    material.roughnessFactor = kRoughness;
    return material;
}

/// Texture coordinates that a map needs and a file does not have: 0, as for a file's own textures.
void ensureCoordinates(Primitive& primitive, LoadedScene& loaded)
{
    if (!primitive.uvs[0].empty())
        return;
    primitive.uvs[0].assign(primitive.positions.size(), vec2(0.0f));
    loaded.warnings.push_back(primitive.name + " has no texture coordinates for the maps: 0 is used");
}

} // namespace

void declareMaterialOptions(CLI::App& app, MaterialOptions& options)
{
    const char* group = "Material";
    std::vector<std::string> names;
    for (const NamedMaterial& material : namedMaterials())
        names.emplace_back(material.name);
    addChoice(app, "--material", options.named, names, "Everything is made of")->group(group);
    app.add_option(
           "--maps", options.maps,
           "Folder of a material's maps, told by their names (..._Color, ..._Roughness, ..._NormalGL): everything "
           "is drawn with it")
        ->group(group)
        ->type_name("FOLDER");
    app.add_option("--base-color", options.baseColor, "Base colour: #RRGGBB (sRGB) or three linear numbers")
        ->group(group)
        ->type_name("COLOR");
    app.add_option("--metallic", options.metallic, "Metallic, 0 to 1; times the map where there is one")->group(group);
    app.add_option("--roughness", options.roughness, "Perceptual roughness, 0 to 1; times the map where there is one")
        ->group(group);
}

bool choosesMaterial(const MaterialOptions& o)
{
    return !o.named.empty() || !o.maps.empty() || !o.baseColor.empty() || o.metallic || o.roughness;
}

void applyMaterial(const MaterialOptions& options, LoadedScene& loaded)
{
    if (!options.named.empty() && !options.maps.empty())
        throw usageError("--material and --maps exclude each other", "give one of them");
    Scene& scene = loaded.scene;
    scene.images.clear();
    loaded.encodedImages.clear();
    scene.textures.clear();
    Material material = startingMaterial(options, loaded);
    if (!options.baseColor.empty())
        material.baseColorFactor = dvec4(parseBaseColor(options.baseColor), 1.0);
    if (options.metallic)
        material.metallicFactor = checkedFactor("--metallic", *options.metallic);
    if (options.roughness)
        material.roughnessFactor = checkedFactor("--roughness", *options.roughness);
    scene.materials = {material};
    for (Primitive& primitive : scene.primitives) {
        primitive.material = 0;
        if (!scene.textures.empty())
            ensureCoordinates(primitive, loaded);
    }
    SceneFacts& facts = loaded.facts;
    facts.materials.names = {material.name};
    facts.textures.names.assign(scene.textures.size(), "");
    facts.images.names.clear();
    facts.texelBytes = 0;
    for (const TextureImage& image : scene.images) {
        facts.images.names.push_back(image.name);
        facts.texelBytes += image.texels.size();
    }
}

} // namespace torrance
