// The structure of a document as tinygltf reads it: meshes, nodes, materials, cameras, lights, skins, samplers.
#pragma once

#include "files/load_report.h"

#include <nlohmann/json_fwd.hpp>
#include <tiny_gltf.h>

namespace torrance {

/// tinygltf's view of a document that passed every check. It gets no buffers, images or accessor ranges: version 2.7
/// refuses valid ones (an external file longer than byteLength, indices without a buffer view) and reads outside
/// invalid ones, so the bytes are read by this folder's own code, and accessors keep their numbers only as names. It is
/// built without any means to open a file. An Error (input) says what it refused.
tinygltf::Model readModel(const nlohmann::json& document, const LoadReport& report);

} // namespace torrance
