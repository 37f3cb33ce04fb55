#include "make_assets/gltf_file.h"

#include "core/atomic_write.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace torrance::assets {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr int kRepeat = 10497;
constexpr int kClampToEdge = 33071;
constexpr int kLinear = 9729;
constexpr int kLinearMipmapLinear = 9987;

template <typename V>
Json asArray(const V& value)
{
    Json array = Json::array();
    for (int i = 0; i < V::length(); ++i)
        array.push_back(value[i]);
    return array;
}

/// The file as it grows.
struct Document
{
    Json json;
    std::vector<std::byte> buffer;
    std::vector<std::string> pictures; // texture i is picture i
};

/// Appends values as a buffer view and an accessor of their own; returns the accessor.
template <typename T>
int addAccessor(Document& document, const std::vector<T>& values, const char* type, int componentType, int target)
{
    const auto bytes = std::as_bytes(std::span(values));
    document.json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", document.buffer.size()}, {"byteLength", bytes.size()}, {"target", target}});
    document.buffer.insert(document.buffer.end(), bytes.begin(), bytes.end());
    document.json["accessors"].push_back({{"bufferView", document.json["bufferViews"].size() - 1},
                                          {"componentType", componentType},
                                          {"count", values.size()},
                                          {"type", type}});
    return static_cast<int>(document.json["accessors"].size()) - 1;
}

int addPositions(Document& document, const std::vector<vec3>& positions)
{
    const int accessor = addAccessor(document, positions, "VEC3", kFloat, kArrayBuffer);
    vec3 low = positions.front();
    vec3 high = positions.front();
    for (const vec3& position : positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    document.json["accessors"].back()["min"] = asArray(low);
    document.json["accessors"].back()["max"] = asArray(high);
    return accessor;
}

int textureNumber(Document& document, const std::string& file)
{
    const auto found = std::find(document.pictures.begin(), document.pictures.end(), file);
    if (found == document.pictures.end())
        document.pictures.push_back(file);
    return static_cast<int>(std::find(document.pictures.begin(), document.pictures.end(), file) -
                            document.pictures.begin());
}

void useExtension(Document& document, const std::string& name)
{
    Json& used = document.json["extensionsUsed"];
    if (std::find(used.begin(), used.end(), name) == used.end())
        used.push_back(name);
}

Json textureInfo(Document& document, const PictureUse& use)
{
    Json info = {{"index", textureNumber(document, use.file)}};
    if (use.transformed()) {
        useExtension(document, "KHR_texture_transform");
        info["extensions"]["KHR_texture_transform"] = {
            {"offset", asArray(use.offset)}, {"rotation", use.rotation}, {"scale", asArray(use.repeat)}};
    }
    return info;
}

Json materialJson(Document& document, const DemoMaterial& material, const std::string& occlusion)
{
    Json json = {{"name", material.name}};
    Json& surface = json["pbrMetallicRoughness"];
    surface = {{"baseColorFactor", asArray(material.baseColor)},
               {"metallicFactor", material.roughnessPicture.used() ? 1.0 : material.metallic},
               {"roughnessFactor", material.roughness}};
    if (material.baseColorPicture.used())
        surface["baseColorTexture"] = textureInfo(document, material.baseColorPicture);
    if (material.roughnessPicture.used())
        surface["metallicRoughnessTexture"] = textureInfo(document, material.roughnessPicture);
    if (material.normalPicture.used()) {
        json["normalTexture"] = textureInfo(document, material.normalPicture);
        json["normalTexture"]["scale"] = material.normalScale;
    }
    json["occlusionTexture"] = {{"index", textureNumber(document, occlusion)}, {"texCoord", 1}};
    if (material.emissive != dvec3(0.0)) {
        json["emissiveFactor"] = asArray(material.emissive);
        if (material.emissivePicture.used())
            json["emissiveTexture"] = textureInfo(document, material.emissivePicture);
        useExtension(document, "KHR_materials_emissive_strength");
        json["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", material.emissiveStrength}};
    }
    if (material.alphaMode != "OPAQUE")
        json["alphaMode"] = material.alphaMode;
    if (material.doubleSided)
        json["doubleSided"] = true;
    return json;
}

void addObject(Document& document, const DemoObject& object, const std::vector<Chart>& charts)
{
    Mesh mesh;
    for (std::size_t i = 0; i < object.parts.size(); ++i)
        appendSurface(mesh, object.parts[i].surface, charts[i], kAtlasSize);
    Json attributes = {{"POSITION", addPositions(document, mesh.positions)},
                       {"NORMAL", addAccessor(document, mesh.normals, "VEC3", kFloat, kArrayBuffer)},
                       {"TEXCOORD_0", addAccessor(document, mesh.uvs, "VEC2", kFloat, kArrayBuffer)},
                       {"TEXCOORD_1", addAccessor(document, mesh.charts, "VEC2", kFloat, kArrayBuffer)}};
    if (object.writesTangents)
        attributes["TANGENT"] = addAccessor(document, mesh.tangents, "VEC4", kFloat, kArrayBuffer);
    const int indices = addAccessor(document, mesh.indices, "SCALAR", kUnsignedInt, kElementArrayBuffer);
    document.json["meshes"].push_back(
        {{"name", object.name},
         {"primitives",
          Json::array({{{"attributes", attributes}, {"indices", indices}, {"material", object.material}}})}});
    document.json["nodes"].push_back(
        {{"name", object.name},
         {"mesh", document.json["meshes"].size() - 1},
         {"translation", asArray(object.translation)},
         {"rotation", asArray(dvec4(0.0, std::sin(object.turn / 2.0), 0.0, std::cos(object.turn / 2.0)))}});
}

void addCamera(Document& document, const DemoCamera& camera)
{
    document.json["cameras"].push_back(
        {{"type", "perspective"},
         {"perspective",
          {{"yfov", camera.verticalFov}, {"aspectRatio", camera.aspect}, {"znear", 0.1}, {"zfar", 30.0}}}});
    // Looks along -Z: +X is to the right, +Y up.
    const dvec3 back = glm::normalize(camera.position - camera.target);
    const dvec3 right = glm::normalize(glm::cross(dvec3(0.0, 1.0, 0.0), back));
    const dvec3 up = glm::cross(back, right);
    const dmat4 matrix(dvec4(right, 0.0), dvec4(up, 0.0), dvec4(back, 0.0), dvec4(camera.position, 1.0));
    Json numbers = Json::array();
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            numbers.push_back(matrix[column][row]);
    document.json["nodes"].push_back({{"name", "camera"}, {"camera", 0}, {"matrix", numbers}});
}

void addPictures(Document& document, const std::string& occlusion)
{
    document.json["samplers"] = {
        {{"magFilter", kLinear}, {"minFilter", kLinearMipmapLinear}, {"wrapS", kRepeat}, {"wrapT", kRepeat}},
        {{"magFilter", kLinear}, {"minFilter", kLinearMipmapLinear}, {"wrapS", kClampToEdge}, {"wrapT", kClampToEdge}}};
    for (std::size_t i = 0; i < document.pictures.size(); ++i) {
        document.json["images"].push_back({{"uri", document.pictures[i]}});
        document.json["textures"].push_back({{"sampler", document.pictures[i] == occlusion ? 1 : 0}, {"source", i}});
    }
}

} // namespace

void writeGltf(const std::filesystem::path& path, const DemoScene& scene, const std::vector<std::vector<Chart>>& charts,
               const std::string& occlusion)
{
    Document document;
    document.json["asset"] = {{"version", "2.0"}, {"generator", "Torrance make_assets"}};
    document.json["extensionsUsed"] = Json::array();
    document.json["scene"] = 0;
    for (const DemoMaterial& material : scene.materials)
        document.json["materials"].push_back(materialJson(document, material, occlusion));
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        addObject(document, scene.objects[i], charts[i]);
    addCamera(document, scene.camera);
    addPictures(document, occlusion);

    Json nodes = Json::array();
    for (std::size_t i = 0; i < document.json["nodes"].size(); ++i)
        nodes.push_back(i);
    document.json["scenes"] = Json::array({{{"name", "still life"}, {"nodes", nodes}}});
    const std::filesystem::path binary = std::filesystem::path(path).replace_extension(".bin");
    document.json["buffers"] =
        Json::array({{{"uri", binary.filename().string()}, {"byteLength", document.buffer.size()}}});
    writeFile(binary, document.buffer);
    writeFile(path, document.json.dump(1) + "\n");
}

} // namespace torrance::assets
