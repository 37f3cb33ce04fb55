#include "files/gltf_edit.h"

#include "core/error.h"
#include "files/gltf_material_write.h"
#include "files/gltf_saved_check.h"
#include "files/material_difference.h"

#include <algorithm>
#include <map>

namespace torrance {
namespace {

using UvSets = std::array<int, 2>;

constexpr UvSets kPlainSets = {0, 1};

[[noreturn]] void refuse(const std::string& problem)
{
    throw usageError("the edited scene " + problem, "edit the scene that was loaded, and add at the end");
}

bool isIndex(int index, std::size_t count)
{
    return index >= 0 && static_cast<std::size_t>(index) < count;
}

void checkTextures(const Scene& original, const Scene& edited)
{
    if (edited.textures.size() < original.textures.size() || edited.images.size() < original.images.size())
        refuse("has lost textures");
    for (std::size_t i = 0; i < original.textures.size(); ++i)
        if (edited.textures[i].image != original.textures[i].image ||
            edited.textures[i].sampler != original.textures[i].sampler)
            refuse("has changed texture " + std::to_string(i));
    for (const Texture& texture : edited.textures)
        if (!isIndex(texture.image, edited.images.size()))
            refuse("has a texture without an image");
}

void checkMaterials(const Scene& original, const Scene& edited)
{
    if (edited.materials.size() < original.materials.size())
        refuse("has lost materials");
    for (const Material& material : edited.materials) {
        if (const std::string field = differingField(material, material); !field.empty()) // of all values only NaN does
            refuse("has a material (" + material.name + ") whose " + field + " is no number");
        for (const auto& [name, use] : kTextureUses)
            if (const TextureUse& used = material.*use;
                used.used() && (!isIndex(used.texture, edited.textures.size()) || !isIndex(used.uvSet, 2)))
                refuse("has a material without the texture that it uses");
    }
}

void checkPrimitives(const Scene& original, const Scene& edited)
{
    if (edited.primitives.size() != original.primitives.size())
        refuse("has other primitives");
    for (const Primitive& primitive : edited.primitives)
        if (primitive.material != -1 && !isIndex(primitive.material, edited.materials.size()))
            refuse("has a primitive without the material that it has");
}

class EditWriter
{
public:
    EditWriter(GltfDraft& to, GltfNumbers& documentNumbers, const GltfEdit& from)
        : draft(to), numbers(documentNumbers), edit(from), before(from.loaded.scene), items(from.loaded.items)
    {
    }

    GltfEdited write()
    {
        chooseSets();
        checkSets();
        for (std::size_t i = 0; i < edit.edited.materials.size(); ++i)
            writeOne(i);
        writePrimitives();
        return std::move(result);
    }

private:
    /// What the vertices of a primitive were loaded with.
    UvSets setsOfPrimitive(std::size_t index) const
    {
        const int material = before.primitives[index].material;
        return material < 0 ? kPlainSets : items.uvSets[static_cast<std::size_t>(material)];
    }

    /// A new material samples the sets of the first primitive that has it.
    void chooseSets()
    {
        sets = items.uvSets;
        sets.resize(edit.edited.materials.size(), kPlainSets);
        const std::vector<Primitive>& primitives = edit.edited.primitives;
        for (std::size_t i = primitives.size(); i-- > 0;)
            if (const auto material = static_cast<std::size_t>(primitives[i].material);
                primitives[i].material >= 0 && material >= before.materials.size())
                sets[material] = setsOfPrimitive(i);
    }

    void checkSets() const
    {
        for (std::size_t i = 0; i < edit.edited.primitives.size(); ++i) {
            const int material = edit.edited.primitives[i].material;
            if (material < 0)
                continue;
            const UvSets wanted = sets[static_cast<std::size_t>(material)];
            const UvSets has = setsOfPrimitive(i);
            const Material& look = edit.edited.materials[static_cast<std::size_t>(material)];
            for (const auto& [name, use] : kTextureUses)
                if (const auto slot = static_cast<std::size_t>((look.*use).uvSet);
                    (look.*use).used() && wanted[slot] != has[slot])
                    throw usageError(edit.file + ": material \"" + look.name + "\" samples TEXCOORD_" +
                                         std::to_string(wanted[slot]) + ", and " + edit.edited.primitives[i].name +
                                         " was loaded with TEXCOORD_" + std::to_string(has[slot]),
                                     "give it a duplicate of the material");
        }
    }

    void writeOne(std::size_t index)
    {
        OrderedJson& list = arrayOf(draft.document, "materials");
        const Material after = inFileNumbers(edit.edited.materials[index], numbers.textures, sets[index]);
        if (index < before.materials.size()) {
            const Material old = inFileNumbers(before.materials[index], numbers.textures, sets[index]);
            writeMaterial(list[static_cast<std::size_t>(numbers.materials[index])], old, after);
        } else {
            const int model = modelOf(index);
            Material old;
            OrderedJson json = OrderedJson::object();
            if (model >= 0) {
                old = result.materials[static_cast<std::size_t>(model)];
                json = list[static_cast<std::size_t>(numbers.materials[static_cast<std::size_t>(model)])];
            }
            writeMaterial(json, old, after);
            numbers.materials.push_back(static_cast<int>(list.size()));
            list.push_back(std::move(json));
        }
        result.materials.push_back(after);
    }

    /// An earlier material, so that it has been written, or -1.
    int modelOf(std::size_t index) const
    {
        const std::size_t added = index - before.materials.size();
        const std::vector<int>& list = edit.options.duplicateOf;
        return added < list.size() && isIndex(list[added], index) ? list[added] : -1;
    }

    void writePrimitives()
    {
        std::map<std::pair<int, int>, int> chosen; // of mesh and primitive → the edited scene's materials
        for (std::size_t i = 0; i < items.primitives.size(); ++i) {
            const int material = edit.edited.primitives[i].material;
            const auto& [mesh, primitive] = items.primitives[i];
            if (material == before.primitives[i].material)
                continue;
            const auto [entry, isNew] = chosen.try_emplace({mesh, primitive}, material);
            if (!isNew && entry->second != material)
                throw usageError(edit.file + ": " + edit.edited.primitives[i].name +
                                     " is shown in several poses, and they were given different materials",
                                 "give them the same: in the file they are one primitive");
        }
        for (const auto& [place, material] : chosen)
            writePrimitive(place.first, place.second, material);
        for (std::size_t i = 0; i < items.primitives.size(); ++i) {
            const auto found = chosen.find({items.primitives[i].mesh, items.primitives[i].primitive});
            const int material = found == chosen.end() ? before.primitives[i].material : found->second;
            result.primitiveMaterials.push_back(material < 0 ? -1
                                                             : numbers.materials[static_cast<std::size_t>(material)]);
        }
    }

    void writePrimitive(int mesh, int primitive, int material)
    {
        OrderedJson& meshJson = draft.document["meshes"][static_cast<std::size_t>(mesh)];
        OrderedJson& json = meshJson["primitives"][static_cast<std::size_t>(primitive)];
        if (material < 0)
            json.erase("material");
        else
            json["material"] = numbers.materials[static_cast<std::size_t>(material)];

        const OrderedJson& nodes = arrayOf(draft.document, "nodes");
        const auto users = std::count_if(nodes.begin(), nodes.end(),
                                         [&](const OrderedJson& node) { return node.value("mesh", -1) == mesh; });
        if (users > 1)
            draft.remarks.push_back(oneLine(edit.file + ": /meshes/" + std::to_string(mesh) + " (" +
                                            meshJson.value("name", std::string()) + ") is shown by " +
                                            std::to_string(users) + " nodes: all of them have the new material"));
    }

    GltfDraft& draft;
    GltfNumbers& numbers;
    const GltfEdit& edit;
    const Scene& before;
    const FileItems& items;
    std::vector<UvSets> sets; // of the edited materials
    GltfEdited result;
};

} // namespace

void checkEdit(const Scene& original, const Scene& edited, const GltfSaveOptions& options)
{
    checkTextures(original, edited);
    checkMaterials(original, edited);
    checkPrimitives(original, edited);
    if (options.pictures.size() != edited.images.size() - original.images.size())
        refuse("has " + std::to_string(edited.images.size() - original.images.size()) + " new images and files of " +
               std::to_string(options.pictures.size()));
}

GltfEdited writeEdit(GltfDraft& draft, GltfNumbers& numbers, const GltfEdit& edit)
{
    return EditWriter(draft, numbers, edit).write();
}

} // namespace torrance
