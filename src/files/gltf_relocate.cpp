#include "files/gltf_relocate.h"

#include "files/gltf_uri.h"
#include "files/gltf_uri_write.h"
#include "files/read_file.h"
#include "files/texture_file.h"

#include <algorithm>
#include <type_traits>

namespace torrance {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBufferType = "application/octet-stream";

/// Every "uri" of the document but those in extras, which are nobody's but their author's. As deep as reading lets it
/// be (kMaxJsonDepth).
template <typename Tree, typename Visit>
void forEachUri(Tree& json, const Visit& visit)
{
    using Text = std::conditional_t<std::is_const_v<Tree>, const std::string&, std::string&>;
    for (auto member = json.begin(); member != json.end(); ++member) {
        const bool isMember = json.is_object();
        if (isMember && member.key() == "uri" && member->is_string())
            visit(member->template get_ref<Text>());
        else if (member->is_structured() && !(isMember && member.key() == "extras"))
            forEachUri(*member, visit);
    }
}

std::vector<std::byte> bytesOf(const std::string& uri, const GltfOrigin& origin, const std::string& file,
                               const std::string& item)
{
    if (auto data = dataOfUri(uri, file, item))
        return std::move(*data);
    return readFile(pathOfUri(uri, origin.folder, origin.allowExternal, file, item), file, item);
}

void embedBuffer(GltfDraft& draft, std::size_t index, const GltfOrigin& origin, const std::string& file)
{
    OrderedJson& buffer = draft.document["buffers"][index];
    const std::string uri = buffer.value("uri", std::string());
    const bool isData = uri.starts_with("data:");
    if (uri.empty() || (isData && index > 0))
        return;
    std::vector<std::byte> bytes = bytesOf(uri, origin, file, itemName("buffers", index));
    bytes.resize(std::min(bytes.size(), buffer.at("byteLength").get<std::size_t>())); // a file may be longer
    if (index > 0) {
        buffer["uri"] = dataUri(bytes, kBufferType);
        return;
    }
    draft.binary = std::move(bytes);
    if (!draft.binary.empty())
        buffer.erase("uri");
}

void embedImage(GltfDraft& draft, std::size_t index, const GltfOrigin& origin, const std::string& file)
{
    OrderedJson& image = draft.document["images"][index];
    const std::string uri = image.value("uri", std::string());
    if (!isRelativeUri(uri) && !origin.allowExternal)
        return;
    if (uri.empty() || uri.starts_with("data:"))
        return;
    const std::string item = itemName("images", index);
    const std::vector<std::byte> bytes = bytesOf(uri, origin, file, item);
    const std::string known = textureMimeType(bytes);
    const std::string mimeType = known.empty() ? image.value("mimeType", std::string()) : known;
    if (mimeType.empty())
        throw inputError(file, item, "is of an unknown type", "give it a mimeType");
    image.erase("uri");
    OrderedJson embedded = embeddedImage(draft, bytes, mimeType);
    draft.document["images"][index].update(embedded);
}

/// Does it for each item; one that fails stays as it is.
template <typename Embed>
void embedAll(GltfDraft& draft, const char* array, const GltfOrigin& origin, const std::string& file, Embed&& embed)
{
    const auto items = draft.document.find(array);
    const std::size_t count = items == draft.document.end() ? 0 : items->size();
    for (std::size_t i = 0; i < count; ++i)
        try {
            embed(draft, i, origin, file);
        } catch (const Error& failure) {
            draft.remarks.push_back(std::string(failure.what()) + "; it stays outside the .glb");
        }
}

} // namespace

void embedFiles(GltfDraft& draft, const GltfOrigin& origin, const std::string& file)
{
    embedAll(draft, "buffers", origin, file, embedBuffer);
    embedAll(draft, "images", origin, file, embedImage);
}

void moveBinaryIntoText(GltfDraft& draft, const std::string& file)
{
    const auto buffers = draft.document.find("buffers");
    const bool isBuffer = buffers != draft.document.end() && !buffers->empty() && !(*buffers)[0].contains("uri");
    if (isBuffer && !draft.binary.empty()) {
        OrderedJson& buffer = (*buffers)[0];
        const std::size_t length = std::min(draft.binary.size(), buffer.at("byteLength").get<std::size_t>());
        buffer["uri"] = dataUri(std::span(draft.binary).first(length), kBufferType); // without the chunk's filling
    }
    draft.binary.clear();
    if (!draft.chunks.empty())
        draft.remarks.push_back(oneLine(file + ": has chunks of extensions, which a .gltf has no place for"));
    draft.chunks.clear();
}

void relocateUris(GltfDraft& draft, const GltfOrigin& from, const fs::path& to)
{
    if (fs::weakly_canonical(fs::absolute(from.folder)) == fs::weakly_canonical(fs::absolute(to)))
        return;
    forEachUri(draft.document, [&](std::string& uri) {
        if (uri.empty() || !isRelativeUri(uri))
            return;
        std::string path = percentDecoded(uri);
        if (!from.allowExternal) // as loading reads it
            std::replace(path.begin(), path.end(), '\\', '/');
        uri = relativeUri(from.folder / path, to);
    });
}

std::string uriOutsideFolder(const GltfDraft& draft)
{
    std::string outside;
    forEachUri(draft.document, [&](const std::string& uri) {
        if (outside.empty() && isRelativeUri(uri) && leavesTheFolder(percentDecoded(uri)))
            outside = uri;
    });
    return outside;
}

} // namespace torrance
