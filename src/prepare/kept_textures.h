// Pictures that were drawn before, kept on disk: what is known of their texels, and their levels as a device has them.
// With both a picture need not be decoded again.
#pragma once

#include "core/disk_cache.h"
#include "plan/texel_facts.h"
#include "plan/texture_plan.h"
#include "scene/known_image.h"

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace torrance {

class KeptTextures
{
public:
    struct Picture
    {
        KnownImage image;
        TexelFacts facts;
    };

    /// In folders of its own below; empty: nothing is kept.
    explicit KeptTextures(const std::filesystem::path& cacheFolder);

    /// By the hash of the picture's encoded bytes. What was found or kept once is found again, also where the file has
    /// gone since.
    std::optional<Picture> find(const ContentHash& encoded);
    void keep(const ContentHash& encoded, const Picture& picture);

    /// All levels of a texture, laid out as the key says: as memory where they are large enough for pages of their own;
    /// written to `memory` where they are not. False where they are not kept, or damaged: what was written then is not
    /// to be used.
    std::optional<MappedFile> mapLevels(const ContentHash& key) const;
    bool readLevels(const ContentHash& key, std::span<std::byte> memory) const;
    void keepLevels(const ContentHash& key, std::span<const std::byte> memory);

private:
    DiskCache pictures;
    DiskCache textures;
    std::map<std::string, Picture> known; // by hex()
};

/// What is known of the texels of a scene's pictures, in their order: where a picture has none, of `kept`, which must
/// know it. What is found out is kept. `encoded` are the hashes of their encoded bytes; empty: nothing is asked for or
/// kept.
std::vector<TexelFacts> texelFacts(const Scene& scene, std::span<const ContentHash> encoded, KeptTextures& kept);

/// Of the levels of a texture from `finestLevel` on, which lie in memory as the numbers `layout` say; nothing where
/// nobody knows the encoded bytes behind its pictures: `encoded`, by Scene::images, is empty then.
std::optional<ContentHash> levelsKey(const PlannedTexture& texture, std::span<const ContentHash> encoded,
                                     int finestLevel, std::span<const std::size_t> layout);

} // namespace torrance
