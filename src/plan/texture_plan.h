// The textures that the device gets: a material's channels packed into as few as draw the same picture.
#pragma once

#include "plan/shader_key.h"
#include "scene/scene.h"

#include <array>
#include <optional>
#include <span>

namespace torrance {

/// A channel of one of Scene::images.
struct ChannelSource
{
    int image = -1; // -1: nothing reads it
    int channel = 0;

    auto operator<=>(const ChannelSource&) const = default;
};

/// The channels of texel words (shaders/shared/texel_words.h), four by four: base colour and metallic, normal and
/// roughness, emission and occlusion.
using WordChannels = std::array<ChannelSource, 12>;

struct PlannedTexture
{
    TexelContent content = TexelContent::color; // of the first three channels; the fourth is linear
    std::array<ChannelSource, 4> channels;      // of images of this size
    int width = 0;
    int height = 0;
    Sampler sampler;
    bool weighByAlpha = false;              // colours count by their alpha where texels are averaged
    bool lengthInAlpha = false;             // of normals: the length of their mean, which Toksvig's filter reads
    std::optional<WordChannels> words = {}; // in place of `content` and `channels`

    auto operator<=>(const PlannedTexture&) const = default;
};

/// What a shader reads from each of its textures.
enum class TextureRole
{
    baseColor,
    material, // R = occlusion, G = roughness, B = metallic
    normal,
    occlusion, // R
    emissive,
    words, // of all of them, which are not there then
};
inline constexpr std::size_t kTextureRoles = 6;

/// ShadingPlan::textures by TextureRole; -1 = none.
using TextureSet = std::array<int, kTextureRoles>;
inline constexpr TextureSet kNoTextures = {-1, -1, -1, -1, -1, -1};

/// The channels that are read of Scene::images; of others `image` is -1.
std::span<const ChannelSource> sourcesOf(const PlannedTexture& texture);

/// Where and how a material reads the texture of a role; scalars that lie in another's alpha are read where that is.
const TextureUse& useOf(const Material& material, TextureRole role);

/// Where all textures of the set are read: the use of one of them. Null where they are read at several places, or there
/// are none.
const TextureUse* sharedPlace(const Material& material, const TextureSet& textures);

/// By role; nothing where a shader reads none.
using RoleTextures = std::array<std::optional<PlannedTexture>, kTextureRoles>;

/// Which of a material's uses a primitive can draw, and which scalars vary over them.
struct TextureNeeds
{
    TextureKey baseColor, metallicRoughness, normal, occlusion, emissive;
    bool roughness = false, metallic = false; // varies over metallicRoughness
    bool lengthInAlpha = false;               // of the normal map
    bool nearestLevel = false;                // stands for the mean of two levels
    bool words = false;                       // are drawn where they can be
};

/// Packs what `needs` names: single channels go into alphas that nothing else needs, where both are sampled alike, are
/// of one size, and the alpha holds all their bits; what is left of occlusion, roughness and metallic shares one
/// texture where it can. The pictures are the same but for the rounding of 8 bits to half floats (2^-12). Sets the
/// key's textures and places. Where TextureNeeds::words asks for it, and three or more would be read, one texture of
/// words takes their place, if all are of one size and 8 bits, sampled alike, repeated and trilinear, and no alpha of
/// the base colour and no length of normals is read.
RoleTextures planTextures(const Scene& scene, const Material& material, const TextureNeeds& needs, ShaderKey& key);

} // namespace torrance
