#include "files/gltf_saved_check.h"

#include "files/gltf_materials.h"
#include "files/gltf_model.h"
#include "files/gltf_open.h"
#include "files/material_difference.h"

#include <algorithm>

namespace torrance {
namespace {

class SavedCheck
{
public:
    SavedCheck(const GltfExpectation& what, const std::string& name) : expected(what), target(name) {}

    /// From the document, because loading leaves out what no primitive has.
    void checkMaterials(const std::filesystem::path& written) const
    {
        LoadReport report;
        report.file = target;
        const OpenedGltf opened = openGltf(written, target);
        const tinygltf::Model model = readModel(opened.document, report);
        for (std::size_t i = 0; i < expected.materials.size(); ++i) {
            const auto number = static_cast<std::size_t>(expected.numbers.materials[i]);
            const GltfMaterial read = readMaterial(model, number, report);
            const std::string field = differingField(
                inFileNumbers(read.material, identity(model.textures.size()), read.uvSets), expected.materials[i]);
            if (!field.empty())
                fail("/materials/" + std::to_string(number) + " (" + expected.materials[i].name + "): " + field);
        }
    }

    void checkScene(const LoadedScene& loaded) const
    {
        const Scene& edited = expected.edited;
        if (loaded.items.primitives != expected.items.primitives ||
            loaded.scene.instances.size() != edited.instances.size())
            fail("the list of what is drawn");
        for (std::size_t i = 0; i < edited.primitives.size(); ++i) {
            const Primitive& read = loaded.scene.primitives[i];
            const int material =
                read.material < 0 ? -1 : loaded.items.materials[static_cast<std::size_t>(read.material)];
            if (material != expected.primitiveMaterials[i])
                fail(itemOf(i) + "/material");
            if (!sameGeometry(read, edited.primitives[i]))
                fail(itemOf(i) + " (its vertices)");
        }
        for (std::size_t i = 0; i < loaded.scene.textures.size(); ++i)
            checkTexture(loaded, i);
    }

private:
    static std::vector<int> identity(std::size_t count)
    {
        std::vector<int> numbers(count);
        for (std::size_t i = 0; i < count; ++i)
            numbers[i] = static_cast<int>(i);
        return numbers;
    }

    std::string itemOf(std::size_t primitive) const
    {
        const FileItems::MeshPrimitive& item = expected.items.primitives[primitive];
        return "/meshes/" + std::to_string(item.mesh) + "/primitives/" + std::to_string(item.primitive);
    }

    void checkTexture(const LoadedScene& loaded, std::size_t index) const
    {
        const int number = loaded.items.textures[index];
        const auto& known = expected.numbers.textures;
        const auto found = std::find(known.begin(), known.end(), number);
        if (found == known.end())
            return; // of a material that was not drawn before: nothing is known of it
        const Texture& read = loaded.scene.textures[index];
        const Texture& wanted = expected.edited.textures[static_cast<std::size_t>(found - known.begin())];
        if (read.sampler != wanted.sampler)
            fail("/textures/" + std::to_string(number) + "/sampler");
        if (!sameTexels(loaded.scene.images[static_cast<std::size_t>(read.image)],
                        expected.edited.images[static_cast<std::size_t>(wanted.image)]))
            fail("the picture of /textures/" + std::to_string(number));
    }

    [[noreturn]] void fail(const std::string& item) const
    {
        throw writeError(target, item + " would read back otherwise, and nothing was written",
                         "set it to what glTF can hold");
    }

    const GltfExpectation& expected;
    const std::string& target;
};

} // namespace

Material inFileNumbers(Material material, const std::vector<int>& textures, const std::array<int, 2>& uvSets)
{
    for (const auto& [name, use] : kTextureUses)
        if ((material.*use).used()) {
            (material.*use).texture = textures[static_cast<std::size_t>((material.*use).texture)];
            (material.*use).uvSet = uvSets[static_cast<std::size_t>((material.*use).uvSet)];
        }
    return material;
}

bool sameGeometry(const Primitive& a, const Primitive& b)
{
    return a.topology == b.topology && a.positions == b.positions && a.normals == b.normals &&
           a.tangents == b.tangents && a.colors == b.colors && a.indices == b.indices;
}

bool sameTexels(const TextureImage& a, const TextureImage& b)
{
    return a.width == b.width && a.height == b.height && a.format == b.format && a.texels == b.texels;
}

void checkSaved(const std::filesystem::path& written, const LoadOptions& options, const GltfExpectation& expected,
                const std::string& target)
{
    const SavedCheck check(expected, target);
    try {
        check.checkMaterials(written);
        check.checkScene(loadScene(written, options));
    } catch (const std::exception& failure) {
        const auto* error = dynamic_cast<const Error*>(&failure);
        if (error != nullptr && error->exitCode == ExitCode::cannotWrite)
            throw;
        throw writeError(target, "would not load, and nothing was written (" + std::string(failure.what()) + ")",
                         "undo the last edits");
    }
}

} // namespace torrance
