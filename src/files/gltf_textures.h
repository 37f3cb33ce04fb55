// Textures of glTF: which image, sampled how, and the image's texels.
#pragma once

#include "files/gltf_buffers.h"
#include "scene/known_image.h"

#include <nlohmann/json_fwd.hpp>
#include <set>
#include <stop_token>

namespace tinygltf {
class Model;
}

namespace torrance {

struct GltfTextures
{
    std::vector<Texture> textures;    // in the order of the file, those asked for
    std::vector<TextureImage> images; // each once
    std::vector<int> textureOfFile;   // the file's number → textures, -1 = not asked for
    std::vector<int> fileImages;      // images → the file's numbers
    std::vector<ContentHash> encoded; // images → the hashes of their encoded bytes; empty where nobody asked
};

/// The textures of the file that `used` names, their images decoded on all cores. Of an image in WebP and one in
/// another format the WebP one is taken (EXT_texture_webp). Pictures that `known` knows are not decoded. Errors
/// (input): a texture without an image that can be read, an image that is missing, damaged, of no size or too large,
/// more than `maxTexelBytes` in all (known from the headers, before anything is decoded), an unknown sampler value.
/// Throws Cancelled where a stop was asked for, which is looked at before each image.
GltfTextures readTextures(const tinygltf::Model& model, const nlohmann::json& document, const GltfBuffers& buffers,
                          const GltfOrigin& origin, const std::set<int>& used, std::uint64_t maxTexelBytes,
                          const std::stop_token& stop, const KnownImages& known, const LoadReport& report);

} // namespace torrance
