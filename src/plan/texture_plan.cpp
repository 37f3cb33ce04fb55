#include "plan/texture_plan.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace torrance {
namespace {

/// Eight texels of words take as long as two or three trilinear samples: `torrance bench --vary
/// texture-filter=trilinear,trilinear_words`.
constexpr std::ptrdiff_t kLeastTextures = 3;
/// The most texels of one texture of words: with its levels 1.4 GB, and devices may have no more than 2 GB in one
/// piece.
constexpr std::int64_t kMostWords = std::int64_t(8192) * 8192;

/// One channel that a shader needs by itself.
struct Scalar
{
    const TextureUse* use;
    int channel;
    ScalarPlace* place;
};

class Packer
{
public:
    Packer(const Scene& s, const Material& m, const TextureNeeds& n, ShaderKey& k)
        : scene(s), material(m), needs(n), key(k)
    {
    }

    RoleTextures run()
    {
        addColors();
        std::vector<Scalar> gloss, ambient; // of metallicRoughness, of occlusion
        if (needs.metallic)
            gloss.push_back({&material.metallicRoughness, 2, &key.metallic});
        if (needs.roughness)
            gloss.push_back({&material.metallicRoughness, 1, &key.roughness});
        if (needs.occlusion.used)
            ambient.push_back({&material.occlusion, 0, &key.ambient});
        std::vector<Scalar> all = gloss;
        all.insert(all.end(), ambient.begin(), ambient.end());
        // From the fewest textures to the most.
        if (placeInAlphas(all))
            return textures;
        if (!gloss.empty() && !ambient.empty() && shareSize(material.metallicRoughness, material.occlusion)) {
            addMaterial(true);
            return textures;
        }
        const bool ambientPlaced = placeInAlphas(ambient);
        if (ambientPlaced || !placeInAlphas(gloss))
            addMaterial(false);
        if (!ambientPlaced)
            addOcclusion();
        return textures;
    }

    /// All that the shader reads as one texture of words, or nothing where they cannot hold it.
    std::optional<PlannedTexture> words() const
    {
        const TextureUse* first = nullptr;
        for (const auto& [drawn, use] : uses()) {
            if (!use->used())
                continue;
            if (!drawn->used)
                return std::nullopt; // useOf() would not know
            first = first ? first : use;
            if (!shareSize(*use, *first) || texels(*use).format != TexelFormat::rgba8)
                return std::nullopt;
        }
        if (!first || samplerOf(*first) != Sampler{} || key.alphaMode != AlphaMode::opaque || needs.lengthInAlpha ||
            std::int64_t(texels(*first).width) * texels(*first).height > kMostWords)
            return std::nullopt;
        PlannedTexture texture;
        WordChannels& channels = texture.words.emplace();
        const auto put = [&](std::size_t place, const TextureKey& read, const TextureUse& use, int channel) {
            if (read.used)
                channels[place] = {imageOf(use), channel};
        };
        for (int c = 0; c < 3; ++c) {
            put(std::size_t(c), needs.baseColor, material.baseColor, c);
            put(4 + std::size_t(c), needs.normal, material.normal, c);
            put(8 + std::size_t(c), needs.emissive, material.emissive, c);
        }
        put(3, {.used = needs.metallic}, material.metallicRoughness, 2);
        put(7, {.used = needs.roughness}, material.metallicRoughness, 1);
        put(11, needs.occlusion, material.occlusion, 0);
        texture.sampler = {.magnify = Filter::nearest, .minify = Filter::nearest, .mip = MipFilter::nearest};
        return texture;
    }

    /// The key of a shader that reads words().
    void readWords()
    {
        const bool roughness = key.roughness != ScalarPlace::constant, metallic = key.metallic != ScalarPlace::constant;
        for (const auto& [texture, use] : uses())
            if (texture->used)
                key.words = *texture;
        key.material = key.occlusion = {};
        key.roughness = roughness ? ScalarPlace::words : ScalarPlace::constant;
        key.metallic = metallic ? ScalarPlace::words : ScalarPlace::constant;
        key.ambient = needs.occlusion.used ? ScalarPlace::words : ScalarPlace::constant;
    }

private:
    /// What a primitive can draw of the material's uses.
    std::array<std::pair<const TextureKey*, const TextureUse*>, 5> uses() const
    {
        return {{{&needs.baseColor, &material.baseColor},
                 {&needs.metallicRoughness, &material.metallicRoughness},
                 {&needs.normal, &material.normal},
                 {&needs.occlusion, &material.occlusion},
                 {&needs.emissive, &material.emissive}}};
    }

    std::optional<PlannedTexture>& at(TextureRole role) { return textures[static_cast<std::size_t>(role)]; }

    int imageOf(const TextureUse& use) const { return scene.textures[static_cast<std::size_t>(use.texture)].image; }
    const TextureImage& texels(const TextureUse& use) const
    {
        return scene.images[static_cast<std::size_t>(imageOf(use))];
    }
    const Sampler& samplerOf(const TextureUse& use) const
    {
        return scene.textures[static_cast<std::size_t>(use.texture)].sampler;
    }

    /// The same texel of both is read at every point.
    bool shareSize(const TextureUse& a, const TextureUse& b) const
    {
        return a.uvSet == b.uvSet && a.transform == b.transform && samplerOf(a) == samplerOf(b) &&
               texels(a).width == texels(b).width && texels(a).height == texels(b).height;
    }

    /// The alpha of `whole` can hold the channel to the bit, or to half a float's for colours of 8 bits.
    bool fits(const TextureUse& scalar, const TextureUse& whole) const
    {
        const bool wide = texels(scalar).format == TexelFormat::rgba16;
        return shareSize(scalar, whole) && (!wide || texels(whole).format == TexelFormat::rgba16);
    }

    PlannedTexture whole(const TextureUse& use, TexelContent content) const
    {
        const int image = imageOf(use);
        PlannedTexture texture;
        texture.content = content;
        texture.channels = {ChannelSource{image, 0}, {image, 1}, {image, 2}, {}};
        texture.sampler = samplerOf(use);
        return texture;
    }

    void addColors()
    {
        if (needs.baseColor.used) {
            PlannedTexture texture = whole(material.baseColor, TexelContent::color);
            texture.weighByAlpha = key.alphaMode != AlphaMode::opaque;
            if (texture.weighByAlpha)
                texture.channels[3] = {imageOf(material.baseColor), 3};
            else
                spares.push_back({TextureRole::baseColor, &material.baseColor, ScalarPlace::baseColorAlpha});
            at(TextureRole::baseColor) = texture;
        }
        if (needs.normal.used) {
            PlannedTexture texture = whole(material.normal, TexelContent::normal);
            texture.lengthInAlpha = needs.lengthInAlpha;
            if (!texture.lengthInAlpha)
                spares.push_back({TextureRole::normal, &material.normal, ScalarPlace::normalAlpha});
            at(TextureRole::normal) = texture;
        }
        if (needs.emissive.used) {
            spares.push_back({TextureRole::emissive, &material.emissive, ScalarPlace::emissiveAlpha});
            at(TextureRole::emissive) = whole(material.emissive, TexelContent::color);
        }
        key.baseColor = needs.baseColor;
        key.normal = needs.normal;
        key.emissive = needs.emissive;
    }

    /// All of them, or none.
    bool placeInAlphas(const std::vector<Scalar>& scalars)
    {
        std::vector<Spare> left = spares;
        std::vector<Spare> taken;
        for (const Scalar& scalar : scalars) {
            const auto found =
                std::ranges::find_if(left, [&](const Spare& spare) { return fits(*scalar.use, *spare.use); });
            if (found == left.end())
                return false;
            taken.push_back(*found);
            left.erase(found);
        }
        for (std::size_t i = 0; i < scalars.size(); ++i) {
            at(taken[i].role)->channels[3] = {imageOf(*scalars[i].use), scalars[i].channel};
            *scalars[i].place = taken[i].place;
        }
        spares = left;
        return true;
    }

    void addMaterial(bool withOcclusion)
    {
        if (!needs.roughness && !needs.metallic)
            return;
        const int image = imageOf(material.metallicRoughness);
        PlannedTexture texture;
        texture.content = TexelContent::data;
        texture.sampler = samplerOf(material.metallicRoughness);
        if (withOcclusion) {
            texture.channels[0] = {imageOf(material.occlusion), 0};
            key.ambient = ScalarPlace::material;
        }
        if (needs.roughness) {
            texture.channels[1] = {image, 1};
            key.roughness = ScalarPlace::material;
        }
        if (needs.metallic) {
            texture.channels[2] = {image, 2};
            key.metallic = ScalarPlace::material;
        }
        at(TextureRole::material) = texture;
        key.material = needs.metallicRoughness;
    }

    void addOcclusion()
    {
        if (!needs.occlusion.used)
            return;
        PlannedTexture& texture = at(TextureRole::occlusion).emplace();
        texture.content = TexelContent::data;
        texture.channels[0] = {imageOf(material.occlusion), 0};
        texture.sampler = samplerOf(material.occlusion);
        key.occlusion = needs.occlusion;
        key.ambient = ScalarPlace::own;
    }

    /// An alpha that nothing reads.
    struct Spare
    {
        TextureRole role;
        const TextureUse* use;
        ScalarPlace place;
    };

    const Scene& scene;
    const Material& material;
    const TextureNeeds& needs;
    ShaderKey& key;
    RoleTextures textures;
    std::vector<Spare> spares;
};

} // namespace

std::span<const ChannelSource> sourcesOf(const PlannedTexture& texture)
{
    if (texture.words)
        return *texture.words;
    return texture.channels;
}

const TextureUse& useOf(const Material& m, TextureRole role)
{
    switch (role) {
    case TextureRole::baseColor:
        return m.baseColor;
    case TextureRole::material:
        return m.metallicRoughness;
    case TextureRole::normal:
        return m.normal;
    case TextureRole::occlusion:
        return m.occlusion;
    case TextureRole::words: {
        const TextureUse* const all[] = {&m.baseColor, &m.metallicRoughness, &m.normal, &m.occlusion};
        const auto* const found = std::ranges::find_if(all, &TextureUse::used);
        return found == std::end(all) ? m.emissive : **found;
    }
    case TextureRole::emissive:
        break;
    }
    return m.emissive;
}

const TextureUse* sharedPlace(const Material& material, const TextureSet& textures)
{
    const TextureUse* place = nullptr;
    for (std::size_t role = 0; role < kTextureRoles; ++role) {
        if (textures[role] < 0)
            continue;
        const TextureUse& use = useOf(material, static_cast<TextureRole>(role));
        if (place && (use.uvSet != place->uvSet || use.transform != place->transform))
            return nullptr;
        place = &use;
    }
    return place;
}

RoleTextures planTextures(const Scene& scene, const Material& material, const TextureNeeds& needs, ShaderKey& key)
{
    Packer packer(scene, material, needs, key);
    RoleTextures textures = packer.run();
    if (needs.words && std::ranges::count_if(textures, [](const auto& t) { return t.has_value(); }) >= kLeastTextures)
        if (auto words = packer.words()) {
            packer.readWords();
            textures = {};
            textures[static_cast<std::size_t>(TextureRole::words)] = std::move(words);
        }
    for (std::optional<PlannedTexture>& texture : textures) {
        if (!texture)
            continue;
        const auto sources = sourcesOf(*texture);
        const auto source = std::ranges::find_if(sources, [](const ChannelSource& c) { return c.image >= 0; });
        const TextureImage& image = scene.images[static_cast<std::size_t>(source->image)];
        texture->width = image.width;
        texture->height = image.height;
        if (needs.nearestLevel && texture->sampler.mip == MipFilter::linear)
            texture->sampler.mip = MipFilter::nearest;
    }
    return textures;
}

} // namespace torrance
