#include "files/obj_scene.h"

#include "files/gltf_facts.h"
#include "files/mtl_material.h"
#include "files/mtl_textures.h"
#include "files/obj_primitives.h"
#include "files/read_file.h"
#include "files/sibling_path.h"
#include "files/text_lines.h"

#include <algorithm>
#include <cctype>

namespace torrance {
namespace {

namespace fs = std::filesystem;

ObjText readText(const fs::path& path, const LoadOptions& options, LoadReport& report, std::uint64_t& fileBytes)
{
    if (options.scene)
        throw usageError(report.file + " has no scenes to choose from", "leave the scene out");
    const std::vector<std::byte> bytes = readFile(path, report.file, "");
    if (bytes.size() > kMaxObjBytes)
        report.fail("", "is larger than 1 GiB", "split the model, or convert it to glTF");
    fileBytes = bytes.size();
    return readObjText({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, options.limits, report);
}

/// "mtllib a b.mtl" names one file with a space in its name where that is there, two otherwise.
std::vector<fs::path> pathsOfLibrary(const std::string& library, const fs::path& folder, const LoadOptions& options,
                                     const LoadReport& report)
{
    const auto pathOf = [&](std::string_view name) {
        return siblingPath(name, folder, options.allowExternal, report.file, "mtllib");
    };
    std::error_code failure;
    const fs::path whole = pathOf(library);
    if (library.find_first_of(" \t") == std::string::npos || fs::exists(whole, failure))
        return {whole};
    std::vector<fs::path> paths;
    for (std::string_view rest = library; !rest.empty();)
        paths.push_back(pathOf(takeWord(rest)));
    return paths;
}

std::vector<MtlMaterial> readLibraries(const std::vector<std::string>& libraries, const fs::path& folder,
                                       const LoadOptions& options, LoadReport& report)
{
    std::vector<MtlMaterial> materials;
    for (const std::string& library : libraries)
        for (const fs::path& path : pathsOfLibrary(library, folder, options, report)) {
            std::error_code failure;
            if (!fs::exists(path, failure)) {
                report.warn("mtllib " + library, "there is no such file: its materials are drawn plain");
                continue;
            }
            std::vector<MtlMaterial> own = readMtlFile(path, report);
            std::move(own.begin(), own.end(), std::back_inserter(materials));
        }
    return materials;
}

/// One material of the scene per name that the faces use, in that order; the first definition of a name counts.
void addMaterials(const ObjText& text, const std::vector<MtlMaterial>& library, const LoadOptions& options,
                  Scene& scene, LoadReport& report)
{
    std::vector<MtlPair> pairs;
    for (const std::string& name : text.materials) {
        const auto found =
            std::find_if(library.begin(), library.end(), [&](const MtlMaterial& m) { return m.name == name; });
        if (found == library.end()) {
            if (!library.empty() || text.libraries.empty())
                report.warn("usemtl " + name, "no MTL file defines it: it is drawn plain");
            scene.materials.push_back(plainMaterial());
            scene.materials.back().name = name;
            pairs.push_back({});
            continue;
        }
        scene.materials.push_back(materialOfMtl(*found, report));
        pairs.push_back({&*found, nullptr});
    }
    for (std::size_t i = 0; i < pairs.size(); ++i) // now that the materials stay where they are
        pairs[i].to = &scene.materials[i];
    std::erase_if(pairs, [](const MtlPair& pair) { return pair.from == nullptr; });
    readMtlTextures(pairs, options, scene, report);
}

/// The material of faces without one, added when the first of them comes.
int plainNumber(Scene& scene, int& plain)
{
    if (plain < 0) {
        plain = static_cast<int>(scene.materials.size());
        scene.materials.push_back(plainMaterial());
    }
    return plain;
}

bool isTextured(const Material& material)
{
    return material.baseColor.used() || material.metallicRoughness.used() || material.normal.used() ||
           material.emissive.used();
}

void addPrimitives(std::vector<ObjPrimitive> primitives, Scene& scene, LoadReport& report)
{
    int plain = -1;
    for (ObjPrimitive& added : primitives) {
        Primitive& primitive = added.primitive;
        if (primitive.material < 0)
            primitive.material = plainNumber(scene, plain);
        if (primitive.uvs[0].empty() && isTextured(scene.materials[static_cast<std::size_t>(primitive.material)])) {
            report.warn(primitive.name, "is textured and has no texture coordinates: 0 is used");
            primitive.uvs[0].assign(primitive.positions.size(), vec2(0.0f));
        }
        scene.instances.push_back({static_cast<int>(scene.primitives.size()), added.shape, dmat4(1.0)});
        scene.primitives.push_back(std::move(primitive));
    }
}

SceneFacts factsOf(const ObjText& text, std::uint64_t fileBytes)
{
    SceneFacts facts;
    facts.container = "OBJ";
    facts.fileBytes = fileBytes;
    facts.scene = -1;
    facts.meshes.names = text.shapes;
    facts.materials.names = text.materials;
    return facts;
}

} // namespace

bool isObjFile(const fs::path& path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".obj";
}

LoadedScene loadObj(const fs::path& path, const LoadOptions& options, LoadReport& report)
{
    std::uint64_t fileBytes = 0;
    const ObjText text = readText(path, options, report, fileBytes);
    std::vector<ObjPrimitive> primitives = buildPrimitives(text, parseGeometry(text), options.limits, report);
    const std::vector<MtlMaterial> library = readLibraries(text.libraries, path.parent_path(), options, report);

    LoadedScene loaded;
    loaded.scene.name = path.stem().string();
    addMaterials(text, library, options, loaded.scene, report);
    addPrimitives(std::move(primitives), loaded.scene, report);
    loaded.facts = factsOf(text, fileBytes);
    loaded.facts.primitives = loaded.scene.primitives.size();
    for (const TextureImage& image : loaded.scene.images)
        loaded.facts.images.names.push_back(image.name);
    loaded.facts.textures.names.resize(loaded.scene.textures.size());
    addSceneFacts(loaded.facts, loaded.scene);
    return loaded;
}

SceneFacts readObjFacts(const fs::path& path, const LoadOptions& options)
{
    LoadReport report;
    report.file = path.string();
    std::uint64_t fileBytes = 0;
    const ObjText text = readText(path, options, report, fileBytes);
    return factsOf(text, fileBytes);
}

} // namespace torrance
