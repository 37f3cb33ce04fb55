// What a document refers to, when it is written in another form or to another folder.
#pragma once

#include "files/gltf_buffers.h"
#include "files/gltf_draft.h"

namespace torrance {

/// Of a .gltf that becomes a .glb: buffer 0 becomes its BIN chunk, images in files become views into it, further
/// buffers data URIs, because views and extensions would have to be renumbered otherwise. What cannot be read, which
/// loading did not need, stays outside with a remark.
void embedFiles(GltfDraft& draft, const GltfOrigin& origin, const std::string& file);

/// Of a .glb that becomes a .gltf: the BIN chunk becomes a data URI, so that a save writes one file. Further chunks
/// have no place, which is a remark.
void moveBinaryIntoText(GltfDraft& draft, const std::string& file);

/// Relative URIs, seen from `from`, become those that name the same files from `to`: of buffers, images, and of
/// extensions. Nothing where the folders are the same.
void relocateUris(GltfDraft& draft, const GltfOrigin& from, const std::filesystem::path& to);

/// A relative URI that leaves the folder of the file, "" where there is none.
std::string uriOutsideFolder(const GltfDraft& draft);

} // namespace torrance
