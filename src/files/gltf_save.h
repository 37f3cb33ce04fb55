// A scene whose materials were edited, written back into its glTF file or into another.
#pragma once

#include "files/scene_file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace torrance {

struct GltfSaveOptions
{
    /// As `original` was loaded. Where that was from a file that has been written over since, `source` is a copy of
    /// what it was then, and `readAs` its path.
    LoadOptions load = {};

    /// The PNG, JPEG or WebP files of the images that `edited` has beyond `original`, in their order.
    std::vector<std::filesystem::path> pictures = {};

    /// Of the materials that `edited` has beyond `original`, in their order: which material of `edited` each began as a
    /// duplicate of, -1 = none. A duplicate keeps what this program does not know of a material. May be shorter.
    std::vector<int> duplicateOf = {};
};

/// Writes the file `source` with the materials of `edited` to `target`, whole or not at all; `source` may be `target`.
/// `original` is what loadScene made of it; `edited` is that scene with other values in its materials, other materials
/// at its primitives, and materials, textures and images added at the end. Nothing else of it is written. All that was
/// not edited stays as it is in the file: members, their order, extensions, extras, geometry (compressed or not).
///
/// A save writes one file. A .glb that comes from a .gltf holds its buffers and pictures, a .gltf that comes from a
/// .glb has its buffer as a data URI, and what a .gltf refers to stays where it is: in another folder its URIs are
/// written anew. New pictures are copied into a .glb, and named by a .gltf.
///
/// The result is read back and compared with `edited` before it takes the place of `target`. Returned are remarks, each
/// a line: a mesh that several nodes show has another material for all of them, a new .gltf refers to files outside its
/// folder, which loading must be allowed to follow.
///
/// Errors: usage, where `source` or `target` is no glTF file by its name or `edited` is no edit of `original`; input,
/// where `source` changed since it was loaded or a picture cannot be read; cannotWrite, where a value would not read
/// back as it is (the message names it), or the file cannot be written.
std::vector<std::string> saveGltf(const std::filesystem::path& source, const Scene& original, const Scene& edited,
                                  const std::filesystem::path& target, const GltfSaveOptions& options = {});

} // namespace torrance
