#include "files/mtl_options.h"

#include <algorithm>
#include <array>

namespace torrance {
namespace {

using Values = tinyobj::material_t;
using Holds = MtlMapKey::Holds;

constexpr std::array<MtlMapKey, 8> kKeys = {{
    {"map_Kd", &Values::diffuse_texname, &Values::diffuse_texopt, Holds::color},
    {"map_d", &Values::alpha_texname, &Values::alpha_texopt, Holds::scalar},
    {"map_Pr", &Values::roughness_texname, &Values::roughness_texopt, Holds::scalar},
    {"map_Ns", &Values::specular_highlight_texname, &Values::specular_highlight_texopt, Holds::scalar},
    {"map_Pm", &Values::metallic_texname, &Values::metallic_texopt, Holds::scalar},
    {"norm", &Values::normal_texname, &Values::normal_texopt, Holds::normals},
    {"map_bump", &Values::bump_texname, &Values::bump_texopt, Holds::normals},
    {"map_Ke", &Values::emissive_texname, &Values::emissive_texopt, Holds::color},
}};

} // namespace

const std::span<const MtlMapKey> kMtlMapKeys = kKeys;

const MtlMapKey& mtlMapKey(std::string_view name)
{
    return *std::find_if(kKeys.begin(), kKeys.end(), [&](const MtlMapKey& key) { return key.name == name; });
}

glm::dmat3x2 mtlTransform(const tinyobj::texture_option_t& options)
{
    const dvec2 scale(options.scale[0], options.scale[1]);
    const dvec2 offset(options.origin_offset[0], options.origin_offset[1]);
    // 1 - (s (1 - v) + o) = s v + (1 - s - o)
    return {dvec2(scale.x, 0.0), dvec2(0.0, scale.y), dvec2(offset.x, 1.0 - scale.y - offset.y)};
}

Channel mtlChannel(const tinyobj::texture_option_t& options, Channel matte)
{
    switch (options.imfchan) {
    case 'r':
        return Channel::red;
    case 'g':
        return Channel::green;
    case 'b':
        return Channel::blue;
    case 'l':
        return Channel::luminance;
    default:
        return matte;
    }
}

void warnOfOptions(const MtlMaterial& material, const MtlMapKey& key, LoadReport& report)
{
    const tinyobj::texture_option_t& o = material.values.*key.options;
    const auto warnIf = [&](bool asked, const char* option) {
        if (asked)
            report.warn("material " + material.name,
                        "has " + std::string(key.name) + " " + option + ", which is not followed");
    };
    const auto& t = o.turbulence;
    const bool isBump = key.name == "map_bump"; // whose default is l
    warnIf(t[0] != 0 || t[1] != 0 || t[2] != 0, "-t");
    warnIf(o.brightness != 0 || o.contrast != 1, "-mm");
    warnIf(o.sharpness != 1, "-boost");
    warnIf(o.texture_resolution != -1, "-texres");
    warnIf(!o.blendu, "-blendu");
    warnIf(!o.blendv, "-blendv");
    warnIf(o.type != tinyobj::TEXTURE_TYPE_NONE, "-type");
    warnIf(std::string_view(isBump || key.holds == Holds::scalar ? "rgbml" : "m").find(o.imfchan) ==
               std::string_view::npos,
           "-imfchan");
    warnIf(key.holds != Holds::normals && o.bump_multiplier != 1, "-bm");
    warnIf(!o.colorspace.empty() && (o.colorspace == "sRGB") != (key.holds == Holds::color), "-colorspace");
}

} // namespace torrance
