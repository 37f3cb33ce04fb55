#include "files/gltf_save.h"

#include "core/atomic_write.h"
#include "core/error.h"
#include "files/gltf_edit.h"
#include "files/gltf_extensions_used.h"
#include "files/gltf_relocate.h"
#include "files/gltf_saved_check.h"
#include "files/material_difference.h"
#include "files/obj_scene.h"
#include "files/read_file.h"

#include <algorithm>
#include <cctype>

namespace torrance {
namespace {

namespace fs = std::filesystem;

/// The first lines of a text show how it is indented.
constexpr std::size_t kIndentationSample = 4096;

bool isBinaryName(const fs::path& target)
{
    std::string extension = target.extension().string();
    for (char& c : extension)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (extension != ".glb" && extension != ".gltf")
        throw usageError(target.string() + ": materials are saved to .gltf and .glb", "give it one of these names");
    return extension == ".glb";
}

void checkSource(const fs::path& source)
{
    if (isObjFile(source))
        throw usageError(source.string() + ": materials are saved for .gltf and .glb, not for OBJ",
                         "convert the model to glTF, or save single materials to files");
}

fs::path folderOf(const fs::path& file)
{
    return fs::absolute(file).parent_path();
}

bool sameScene(const Scene& a, const Scene& b)
{
    const auto sameMaterial = [](const Material& x, const Material& y) { return differingField(x, y).empty(); };
    const auto samePrimitive = [](const Primitive& x, const Primitive& y) {
        return x.name == y.name && x.material == y.material && sameGeometry(x, y);
    };
    const auto sameTexture = [](const Texture& x, const Texture& y) {
        return x.image == y.image && x.sampler == y.sampler;
    };
    return std::ranges::equal(a.materials, b.materials, sameMaterial) &&
           std::ranges::equal(a.primitives, b.primitives, samePrimitive) &&
           std::ranges::equal(a.textures, b.textures, sameTexture) &&
           std::ranges::equal(a.images, b.images, sameTexels) && a.instances.size() == b.instances.size();
}

/// The scene again, as the file has it now: it says which items of the document are meant.
LoadedScene loadUnchanged(const fs::path& source, const Scene& original, const LoadOptions& options)
{
    LoadedScene loaded = loadScene(source, options);
    if (!sameScene(loaded.scene, original))
        throw inputError(source.string(), "", "has changed since it was loaded", "load it again");
    return loaded;
}

GltfDraft draftOf(const fs::path& source, const fs::path& target, const GltfSaveOptions& options)
{
    const fs::path& own = options.load.readAs.empty() ? source : options.load.readAs;
    const std::string file = own.string();
    const std::vector<std::byte> bytes = readFile(source, file, "");
    const GltfContainer container = splitContainer(bytes, file);
    const GltfOrigin origin{folderOf(own), options.load.allowExternal};

    GltfDraft draft;
    draft.document = readOrderedJson(container.json, file);
    draft.isBinary = isBinaryName(target);
    if (container.binary)
        draft.binary.assign(container.binary->begin(), container.binary->end());
    draft.chunks.assign(container.furtherChunks.begin(), container.furtherChunks.end());
    draft.indentation = container.isBinary ? "{\n  \"" : std::string(container.json.substr(0, kIndentationSample));
    if (draft.isBinary && !container.isBinary)
        embedFiles(draft, origin, file);
    if (!draft.isBinary && container.isBinary)
        moveBinaryIntoText(draft, file);
    relocateUris(draft, origin, folderOf(target));
    return draft;
}

std::vector<std::string> save(const fs::path& source, const Scene& original, const Scene& edited,
                              const fs::path& target, const GltfSaveOptions& options)
{
    const LoadedScene loaded = loadUnchanged(source, original, options.load);

    const std::string name = target.string();
    GltfDraft draft = draftOf(source, target, options);
    const std::set<std::string> extensions = editableExtensionsIn(draft.document);
    GltfNumbers numbers{loaded.items.materials, loaded.items.textures, loaded.items.images};
    appendTextures(draft, numbers, edited, options.pictures, folderOf(target));
    GltfEdited written = writeEdit(draft, numbers, {loaded, edited, options, name});
    updateExtensionLists(draft.document, extensions);

    LoadOptions reload = options.load;
    reload.readAs.clear(); // the target is read where it lies
    if (const std::string outside = uriOutsideFolder(draft); !outside.empty() && !reload.allowExternal) {
        reload.allowExternal = true;
        draft.remarks.push_back(
            oneLine(name + ": refers to files outside its folder (" + outside + "): it opens with --allow-external"));
    }
    writeFile(target, fileBytes(draft, name), [&](const fs::path& temporary) {
        checkSaved(temporary, reload,
                   {edited, numbers, loaded.items, std::move(written.materials), std::move(written.primitiveMaterials)},
                   name);
    });
    return draft.remarks;
}

} // namespace

std::vector<std::string> saveGltf(const fs::path& source, const Scene& original, const Scene& edited,
                                  const fs::path& target, const GltfSaveOptions& options)
{
    checkSource(source);
    isBinaryName(target);
    checkEdit(original, edited, options);
    try {
        return save(source, original, edited, target, options);
    } catch (const fs::filesystem_error& failure) // a folder on the way that cannot be looked into
    {
        throw writeError(target.string(), failure.code().message(), "check the folders on the way to it");
    }
}

} // namespace torrance
