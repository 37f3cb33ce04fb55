#include "view/saved_scene.h"

#include "files/material_difference.h"

namespace torrance {
namespace {

std::vector<int> readTextures(const std::vector<Material>& materials, std::size_t count)
{
    std::vector<int> readers(count, 0);
    for (const Material& material : materials)
        for (const auto& [name, role] : kTextureUses)
            if ((material.*role).used())
                ++readers[static_cast<std::size_t>((material.*role).texture)];
    return readers;
}

void putMaterials(const Edits& edits, Scene& scene)
{
    scene.materials = edits.materials;
    for (std::size_t i = 0; i < scene.primitives.size(); ++i)
        scene.primitives[i].material = edits.primitiveMaterials[i];
}

} // namespace

SceneToSave sceneToSave(const EditHistory& history, const Scene& scene,
                        const std::vector<std::filesystem::path>& pictures)
{
    SceneToSave result = {.input = {},
                          .sourceCopy = {},
                          .original = scene,
                          .edited = scene,
                          .duplicateOf = history.now().duplicateOf,
                          .pictures = {}};
    putMaterials(history.loaded(), result.original);
    putMaterials(history.now(), result.edited);
    const std::size_t images = scene.images.size() - pictures.size();
    const std::size_t textures = scene.textures.size() - pictures.size();
    result.original.images.resize(images);
    result.original.textures.resize(textures);
    result.edited.images.resize(images);
    result.edited.textures.resize(textures);
    const std::vector<int> readers = readTextures(result.edited.materials, scene.textures.size());
    std::vector<int> placeOf(scene.textures.size());
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        placeOf[i] = static_cast<int>(i < textures ? i : result.edited.textures.size());
        if (i < textures || readers[i] == 0)
            continue;
        result.edited.images.push_back(scene.images[static_cast<std::size_t>(scene.textures[i].image)]);
        result.edited.textures.push_back(scene.textures[i]);
        result.edited.textures.back().image = static_cast<int>(result.edited.images.size()) - 1;
        result.pictures.push_back(pictures[i - textures]);
    }
    for (Material& material : result.edited.materials)
        for (const auto& [name, role] : kTextureUses)
            if ((material.*role).used())
                (material.*role).texture = placeOf[static_cast<std::size_t>((material.*role).texture)];
    return result;
}

} // namespace torrance
