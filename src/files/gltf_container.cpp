#include "files/gltf_container.h"

#include "core/error.h"

#include <cstdint>
#include <cstring>

namespace torrance {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67;     // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A; // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;
constexpr const char* kExportAgain = "the file is damaged or cut short: copy or export it again";

std::uint32_t wordAt(std::span<const std::byte> bytes, std::size_t offset)
{
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + offset, sizeof word); // GLB is little-endian, as every processor we build for
    return word;
}

std::string_view asText(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Chunk
{
    std::uint32_t type = 0;
    std::span<const std::byte> content;
};

Chunk takeChunk(std::span<const std::byte>& rest, const std::string& file, int number)
{
    const std::string item = "GLB chunk " + std::to_string(number);
    if (rest.size() < kChunkHeaderBytes)
        throw inputError(file, item, "its header is cut short", kExportAgain);
    const std::size_t length = wordAt(rest, 0);
    if (length > rest.size() - kChunkHeaderBytes)
        throw inputError(file, item,
                         "claims " + std::to_string(length) + " bytes where " +
                             std::to_string(rest.size() - kChunkHeaderBytes) + " are left",
                         kExportAgain);
    const Chunk chunk{wordAt(rest, 4), rest.subspan(kChunkHeaderBytes, length)};
    rest = rest.subspan(kChunkHeaderBytes + length);
    return chunk;
}

GltfContainer splitBinary(std::span<const std::byte> bytes, const std::string& file)
{
    if (bytes.size() < kHeaderBytes)
        throw inputError(file, "GLB header", "is cut short", kExportAgain);
    if (const std::uint32_t version = wordAt(bytes, 4); version != 2)
        throw inputError(file, "GLB header", "is of version " + std::to_string(version),
                         "only glTF 2.0 is read: convert the file");
    const std::size_t length = wordAt(bytes, 8);
    if (length > bytes.size() || length < kHeaderBytes)
        throw inputError(file, "GLB header",
                         "claims " + std::to_string(length) + " bytes where the file has " +
                             std::to_string(bytes.size()),
                         kExportAgain);

    std::span<const std::byte> rest = bytes.subspan(kHeaderBytes, length - kHeaderBytes);
    const Chunk text = takeChunk(rest, file, 0);
    if (text.type != kJsonChunk)
        throw inputError(file, "GLB chunk 0", "is not of type JSON", kExportAgain);
    GltfContainer container{.json = asText(text.content), .isBinary = true};
    container.furtherChunks = rest;
    // Only the chunk that follows the JSON is its binary buffer; chunks of other types belong to extensions.
    for (int number = 1; !rest.empty(); ++number)
        if (const Chunk chunk = takeChunk(rest, file, number); number == 1 && chunk.type == kBinaryChunk) {
            container.binary = chunk.content;
            container.furtherChunks = rest;
        }
    return container;
}

bool looksLikeJson(std::string_view text)
{
    if (text.starts_with("\xef\xbb\xbf"))
        text.remove_prefix(3);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && text[first] == '{';
}

} // namespace

GltfContainer splitContainer(std::span<const std::byte> bytes, const std::string& file)
{
    if (bytes.empty())
        throw inputError(file, "", "is empty", "export it again");
    if (bytes.size() >= 4 && wordAt(bytes, 0) == kMagic)
        return splitBinary(bytes, file);
    if (!looksLikeJson(asText(bytes)))
        throw inputError(file, "", "is neither a GLB nor glTF JSON", "give a .glb or .gltf file");
    return {.json = asText(bytes)};
}

} // namespace torrance
