// The finished part of a reference picture in a file, to go on with later.
#pragma once

#include "core/content_hash.h"
#include "reference/reference_picture.h"

#include <filesystem>
#include <string_view>

namespace torrance {

/// Everything that a picture's bits depend on: scene, camera, settings, and the program that computes it.
ContentHash hashOfInputs(const Scene& scene, const Camera& camera, const ReferenceSettings& settings,
                         std::string_view program);

/// Whole or not at all.
void writeCheckpoint(const std::filesystem::path& path, const ReferencePicture& picture, const ContentHash& inputs);

/// An Error (input) where the file is missing, damaged, or was made from other inputs.
ReferencePicture readCheckpoint(const std::filesystem::path& path, const ReferenceSettings& settings,
                                const ContentHash& inputs);

} // namespace torrance
