#include "files/gltf_scene.h"

#include "files/gltf_cameras.h"
#include "files/gltf_extensions.h"
#include "files/gltf_instancing.h"
#include "files/gltf_items.h"
#include "files/gltf_lights.h"
#include "files/gltf_materials.h"
#include "files/gltf_model.h"
#include "files/gltf_primitive.h"
#include "files/gltf_skin.h"
#include "files/gltf_textures.h"

#include <map>
#include <tuple>

namespace torrance {
namespace {

class SceneBuilder
{
public:
    SceneBuilder(const GltfDocument& from, LoadReport& messages)
        : document(from), report(messages), model(readModel(from.json, messages)),
          worlds(worldTransforms(model, from.tree, messages)), geometry{model, from.accessors, from.limits,
                                                                        quantizationDeclared(from)}
    {
    }

    GltfScene build(int number)
    {
        const std::vector<int> nodes = nodesOfScene(model, rootsOf(number));
        readMaterials(nodes);
        for (const int node : nodes)
            addNode(static_cast<std::size_t>(node));
        scene.name = number >= 0 ? model.scenes[static_cast<std::size_t>(number)].name : "";
        if (scene.name.empty())
            scene.name = document.stem;
        return {std::move(scene), std::move(items), std::move(encodedImages)};
    }

private:
    static bool quantizationDeclared(const GltfDocument& document)
    {
        const std::vector<std::string> used = extensionNames(document.json, "extensionsUsed");
        return std::find(used.begin(), used.end(), "KHR_mesh_quantization") != used.end();
    }

    std::vector<int> rootsOf(int number) const
    {
        if (number >= 0)
            return model.scenes[static_cast<std::size_t>(number)].nodes;
        std::vector<int> roots;
        for (std::size_t i = 0; i < document.tree.parents.size(); ++i)
            if (document.tree.parents[i] < 0)
                roots.push_back(static_cast<int>(i));
        return roots;
    }

    /// Only materials of what is drawn, in the order of the file, and only the textures that they use.
    void readMaterials(const std::vector<int>& nodes)
    {
        std::set<int> drawn;
        for (const int node : nodes)
            if (const int mesh = model.nodes[static_cast<std::size_t>(node)].mesh; mesh >= 0)
                for (const tinygltf::Primitive& primitive : model.meshes[static_cast<std::size_t>(mesh)].primitives)
                    if (primitive.material >= 0)
                        drawn.insert(primitive.material);

        std::set<int> textures;
        for (const int index : drawn) {
            materialOfFile[index] = static_cast<int>(materials.size());
            materials.push_back(readMaterial(model, static_cast<std::size_t>(index), report));
            items.materials.push_back(index);
            items.uvSets.push_back(materials.back().uvSets);
            for (const TextureUse* use : usesOf(materials.back().material))
                if (use->used())
                    textures.insert(use->texture);
        }
        GltfTextures read = readTextures(model, document.json, document.buffers, document.origin, textures,
                                         document.limits.texelBytes, document.stop, document.known, report);
        for (GltfMaterial& material : materials) {
            for (TextureUse* use : usesOf(material.material))
                if (use->used())
                    use->texture = read.textureOfFile[static_cast<std::size_t>(use->texture)];
            scene.materials.push_back(material.material);
        }
        scene.textures = std::move(read.textures);
        scene.images = std::move(read.images);
        encodedImages = std::move(read.encoded);
        items.textures.assign(textures.begin(), textures.end());
        items.images = std::move(read.fileImages);
    }

    static std::array<TextureUse*, 5> usesOf(Material& material)
    {
        return {&material.baseColor, &material.metallicRoughness, &material.normal, &material.occlusion,
                &material.emissive};
    }

    void addNode(std::size_t index)
    {
        const tinygltf::Node& node = model.nodes[index];
        if (node.mesh >= 0)
            addMesh(node, index);
        if (node.camera >= 0)
            scene.cameras.push_back(readCamera(model, static_cast<std::size_t>(node.camera), worlds[index], report));
        const auto light = node.extensions.find("KHR_lights_punctual");
        if (light != node.extensions.end())
            scene.lights.push_back(readLight(
                model, static_cast<std::size_t>(light->second.Get("light").GetNumberAsInt()), worlds[index], report));
    }

    void addMesh(const tinygltf::Node& node, std::size_t index)
    {
        const std::vector<int>& shown = primitivesOf(node);
        const bool skinned = node.skin >= 0; // its vertices are in the world already
        const auto instances =
            instanceTransforms(node, document.accessors, document.limits.instances, itemName("nodes", index), report);
        if (skinned && instances)
            report.warn(itemName("nodes", index), "is skinned: its EXT_mesh_gpu_instancing is left out");
        if (skinned || !instances)
            return addInstances(shown, index, skinned ? dmat4(1.0) : worlds[index]);
        for (const dmat4& nodeFromInstance : *instances)
            addInstances(shown, index, worlds[index] * nodeFromInstance);
    }

    void addInstances(const std::vector<int>& shown, std::size_t node, const dmat4& world)
    {
        if (scene.instances.size() + shown.size() > document.limits.instances)
            report.fail(itemName("nodes", node),
                        "brings the file to more than " + std::to_string(document.limits.instances) + " instances",
                        "split the model");
        for (const int primitive : shown)
            scene.instances.push_back({primitive, static_cast<int>(node), world});
    }

    /// Nodes that show the same mesh in the same pose share its primitives.
    const std::vector<int>& primitivesOf(const tinygltf::Node& node)
    {
        const tinygltf::Mesh& mesh = model.meshes[static_cast<std::size_t>(node.mesh)];
        const std::vector<double>& weights = node.weights.empty() ? mesh.weights : node.weights;
        const auto [entry, isNew] = primitives.try_emplace(std::tuple(node.mesh, node.skin, weights));
        if (!isNew)
            return entry->second;
        GltfPose pose{weights, nullptr};
        std::vector<dmat4> joints;
        if (node.skin >= 0) {
            joints = jointTransforms(model, node.skin, worlds, document.accessors, report);
            pose.joints = &joints;
        }
        for (std::size_t i = 0; i < mesh.primitives.size(); ++i)
            addPrimitive(node.mesh, i, pose, entry->second);
        return entry->second;
    }

    void addPrimitive(int mesh, std::size_t number, const GltfPose& pose, std::vector<int>& list)
    {
        const int fileMaterial = model.meshes[static_cast<std::size_t>(mesh)].primitives[number].material;
        const int material = fileMaterial < 0 ? -1 : materialOfFile.at(fileMaterial);
        const GltfMaterial plain;
        const GltfMaterial& look = material < 0 ? plain : materials[static_cast<std::size_t>(material)];
        auto primitive = readPrimitive(geometry, mesh, number, pose, look.uvSets, look.textured, report);
        if (!primitive)
            return;
        primitive->material = material;
        list.push_back(static_cast<int>(scene.primitives.size()));
        items.primitives.push_back({mesh, static_cast<int>(number)});
        scene.primitives.push_back(std::move(*primitive));
    }

    const GltfDocument& document;
    LoadReport& report;
    tinygltf::Model model;
    std::vector<dmat4> worlds;
    GltfGeometry geometry;
    Scene scene;
    FileItems items;
    std::vector<ContentHash> encodedImages;
    std::vector<GltfMaterial> materials;
    std::map<int, int> materialOfFile;
    std::map<std::tuple<int, int, std::vector<double>>, std::vector<int>> primitives; // of mesh, skin and weights
};

} // namespace

int sceneNumber(const nlohmann::json& document, const std::optional<int>& chosen, const LoadReport& report)
{
    const auto count = static_cast<int>(itemsOf(document, "scenes").size());
    if (!chosen)
        return count == 0 ? -1 : document.value("scene", 0);
    if (*chosen < 0 || *chosen >= count)
        throw usageError(report.file + " has no scene " + std::to_string(*chosen),
                         count == 0 ? "leave the scene out" : "choose one from 0 to " + std::to_string(count - 1));
    return *chosen;
}

GltfScene buildScene(const GltfDocument& document, int number, LoadReport& report)
{
    return SceneBuilder(document, report).build(number);
}

} // namespace torrance
