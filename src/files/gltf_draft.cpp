#include "files/gltf_draft.h"

#include "core/error.h"
#include "files/gltf_uri_write.h"

#include <cstdint>
#include <limits>

namespace torrance {
namespace {

/// Chunks of a .glb, and accessors of any type in a view, begin at multiples of this (glTF 2.0, 4.4.2 and 3.6.2.4).
constexpr std::size_t kAlignment = 4;
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;

constexpr std::size_t aligned(std::size_t size)
{
    return (size + kAlignment - 1) / kAlignment * kAlignment;
}

void append(std::vector<std::byte>& file, std::span<const std::byte> bytes)
{
    file.insert(file.end(), bytes.begin(), bytes.end());
}

void appendWord(std::vector<std::byte>& file, std::size_t value)
{
    for (int shift = 0; shift < 32; shift += 8)
        file.push_back(static_cast<std::byte>(value >> shift & 255));
}

/// JSON is filled up with spaces, other chunks with zeros.
void appendChunk(std::vector<std::byte>& file, const char* type, std::span<const std::byte> content, char filler)
{
    appendWord(file, aligned(content.size()));
    append(file, std::as_bytes(std::span(type, 4)));
    append(file, content);
    file.resize(file.size() + aligned(content.size()) - content.size(), static_cast<std::byte>(filler));
}

std::vector<std::byte> glbBytes(const std::string& text, const GltfDraft& draft, const std::string& target)
{
    const std::size_t binaryBytes = draft.binary.empty() ? 0 : kChunkHeaderBytes + aligned(draft.binary.size());
    const std::size_t total =
        kHeaderBytes + kChunkHeaderBytes + aligned(text.size()) + binaryBytes + draft.chunks.size();
    if (total > std::numeric_limits<std::uint32_t>::max())
        throw writeError(target, "would be larger than 4 GiB, the most that a .glb can say", "save it as .gltf");
    std::vector<std::byte> file;
    file.reserve(total);
    append(file, std::as_bytes(std::span("glTF", 4)));
    appendWord(file, 2); // version
    appendWord(file, total);
    appendChunk(file, "JSON", std::as_bytes(std::span(text)), ' ');
    if (!draft.binary.empty())
        appendChunk(file, "BIN\0", draft.binary, '\0');
    append(file, draft.chunks);
    return file;
}

} // namespace

OrderedJson& arrayOf(OrderedJson& document, const char* name)
{
    OrderedJson& array = document[name];
    if (array.is_null())
        array = OrderedJson::array();
    return array;
}

bool canHoldBytes(const GltfDraft& draft)
{
    if (!draft.isBinary)
        return false;
    const auto buffers = draft.document.find("buffers");
    if (buffers == draft.document.end() || buffers->empty())
        return true;
    return !draft.binary.empty() && !(*buffers)[0].contains("uri");
}

int appendView(GltfDraft& draft, std::span<const std::byte> bytes)
{
    const std::size_t offset = aligned(draft.binary.size());
    draft.binary.resize(offset);
    append(draft.binary, bytes);
    OrderedJson& buffers = arrayOf(draft.document, "buffers");
    if (buffers.empty())
        buffers.push_back(OrderedJson::object());
    buffers[0]["byteLength"] = draft.binary.size();
    OrderedJson& views = arrayOf(draft.document, "bufferViews");
    views.push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes.size()}});
    return static_cast<int>(views.size()) - 1;
}

OrderedJson embeddedImage(GltfDraft& draft, std::span<const std::byte> bytes, const std::string& mimeType)
{
    if (canHoldBytes(draft))
        return {{"bufferView", appendView(draft, bytes)}, {"mimeType", mimeType}};
    return {{"uri", dataUri(bytes, mimeType)}};
}

std::vector<std::byte> fileBytes(const GltfDraft& draft, const std::string& target)
{
    if (draft.isBinary)
        return glbBytes(orderedJsonText(draft.document, ""), draft, target);
    const std::string text = orderedJsonText(draft.document, draft.indentation) + "\n";
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

} // namespace torrance
