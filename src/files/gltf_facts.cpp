#include "files/gltf_facts.h"

#include "files/gltf_extensions.h"
#include "files/gltf_items.h"

#include <set>

namespace torrance {
namespace {

using nlohmann::json;

NamedItems namesOf(const json& items)
{
    NamedItems named;
    for (const json& item : items)
        named.names.push_back(item.value("name", std::string()));
    return named;
}

std::vector<ExtensionFact> extensionsOf(const json& document)
{
    const std::vector<std::string> required = extensionNames(document, "extensionsRequired");
    const std::vector<std::string> used = extensionNames(document, "extensionsUsed");
    std::set<std::string> names(used.begin(), used.end());
    names.insert(required.begin(), required.end());
    std::vector<ExtensionFact> extensions;
    for (const std::string& name : names)
        extensions.push_back(
            {name, std::find(required.begin(), required.end(), name) != required.end(), isSupportedExtension(name)});
    return extensions;
}

NamedItems lightsOf(const json& document)
{
    const json& extensions = itemsOf(document, "extensions");
    return namesOf(itemsOf(itemsOf(extensions, "KHR_lights_punctual"), "lights"));
}

} // namespace

SceneFacts factsOfDocument(const json& document, const GltfContainer& container, std::size_t fileBytes)
{
    const json& asset = document.at("asset");
    SceneFacts facts;
    facts.container = container.isBinary ? "GLB" : "glTF";
    facts.version = asset.at("version").get<std::string>();
    facts.generator = asset.value("generator", std::string());
    facts.copyright = asset.value("copyright", std::string());
    facts.fileBytes = fileBytes;
    facts.extensions = extensionsOf(document);
    facts.scenes = namesOf(itemsOf(document, "scenes"));
    facts.nodes = namesOf(itemsOf(document, "nodes"));
    facts.meshes = namesOf(itemsOf(document, "meshes"));
    facts.materials = namesOf(itemsOf(document, "materials"));
    facts.textures = namesOf(itemsOf(document, "textures"));
    facts.images = namesOf(itemsOf(document, "images"));
    facts.cameras = namesOf(itemsOf(document, "cameras"));
    facts.lights = lightsOf(document);
    facts.skins = namesOf(itemsOf(document, "skins"));
    facts.animations = namesOf(itemsOf(document, "animations"));
    facts.accessors = itemsOf(document, "accessors").size();
    for (const json& mesh : itemsOf(document, "meshes"))
        for (const json& primitive : itemsOf(mesh, "primitives")) {
            ++facts.primitives;
            facts.morphTargets += itemsOf(primitive, "targets").size();
        }
    return facts;
}

void addSceneFacts(SceneFacts& facts, const Scene& scene)
{
    facts.instances = scene.instances.size();
    for (const Instance& instance : scene.instances) {
        const Primitive& primitive = scene.primitives[static_cast<std::size_t>(instance.primitive)];
        const std::size_t indices = primitive.indices.size();
        facts.vertices += primitive.positions.size();
        facts.triangles += primitive.topology == Topology::triangles ? indices / 3 : 0;
        facts.lines += primitive.topology == Topology::lines ? indices / 2 : 0;
        facts.points += primitive.topology == Topology::points ? indices : 0;
    }
    for (const TextureImage& image : scene.images)
        facts.texelBytes += static_cast<std::uint64_t>(image.width) * static_cast<std::uint64_t>(image.height) *
                            bytesPerTexel(image.format);
}

} // namespace torrance
