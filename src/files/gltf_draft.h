// A glTF document on its way to a file: what is edited before it is written.
#pragma once

#include "files/json_ordered.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace torrance {

struct GltfDraft
{
    OrderedJson document;
    bool isBinary = false;            // .glb
    std::vector<std::byte> binary;    // of a .glb: the content of its BIN chunk; empty = it has none
    std::vector<std::byte> chunks;    // of a .glb: what follows, headers and all
    std::string indentation;          // of a .gltf: a text that is indented as this one will be
    std::vector<std::string> remarks; // what whoever saves should know
};

/// The array of the document, made where there is none.
OrderedJson& arrayOf(OrderedJson& document, const char* name);

/// Whether bytes can be put into the file without touching a buffer that is there: into the chunk of a .glb, which is
/// buffer 0. Not so where that buffer is somewhere else, or nowhere, as EXT_meshopt_compression has it.
bool canHoldBytes(const GltfDraft& draft);

/// The number of a new buffer view over bytes added to the chunk, which what is there stays in front of.
int appendView(GltfDraft& draft, std::span<const std::byte> bytes);

/// An image of these bytes, in a view where the draft can hold them, else in a data URI.
OrderedJson embeddedImage(GltfDraft& draft, std::span<const std::byte> bytes, const std::string& mimeType);

/// The bytes of the file. An Error (cannotWrite) about `target` where they are more than a .glb can hold.
std::vector<std::byte> fileBytes(const GltfDraft& draft, const std::string& target);

} // namespace torrance
