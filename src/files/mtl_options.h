// The maps of an MTL material and their options.
#pragma once

#include "files/channel_pack.h"
#include "files/mtl_file.h"
#include "math/vector.h"

#include <span>

namespace torrance {

struct MtlMapKey
{
    std::string_view name;
    std::string tinyobj::material_t::*file;
    tinyobj::texture_option_t tinyobj::material_t::*options;
    enum class Holds
    {
        color,
        scalar,
        normals,
    } holds;
};

/// Of the keys that become textures.
extern const std::span<const MtlMapKey> kMtlMapKeys;
const MtlMapKey& mtlMapKey(std::string_view name);

/// Of coordinates whose v runs down: MTL's u' = s u + o, with v up, seen from there.
glm::dmat3x2 mtlTransform(const tinyobj::texture_option_t& options);

/// The channel that -imfchan names; `matte` for m, and for those that are unknown.
Channel mtlChannel(const tinyobj::texture_option_t& options, Channel matte);

/// One warning for every option of the map that asks for a change and is not followed.
void warnOfOptions(const MtlMaterial& material, const MtlMapKey& key, LoadReport& report);

} // namespace torrance
