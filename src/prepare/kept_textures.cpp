#include "prepare/kept_textures.h"

#include <algorithm>
#include <cassert>
#include <cstdint>

namespace torrance {
namespace {

/// Change it whenever a file's bytes would give other facts or other levels, or they are kept in another form.
constexpr int kPictureVersion = 1, kLevelsVersion = 3;

constexpr std::uintmax_t kMaxPictureBytes = 1u << 20; // some eight thousand pictures
constexpr std::uintmax_t kMaxLevelBytes = 1u << 30;   // eight models like WaterBottle, by its greatest levels

ContentHash pictureKey(const ContentHash& encoded)
{
    return ContentHasher().add(kPictureVersion).add(encoded.high).add(encoded.low).finish();
}

/// A picture as it lies on disk.
struct PictureRecord
{
    std::int32_t width, height;
    std::uint32_t format, unused;
    std::array<double, 4> least, greatest;
};
static_assert(sizeof(PictureRecord) == 80);

} // namespace

KeptTextures::KeptTextures(const std::filesystem::path& folder)
    : pictures(folder.empty() ? folder : folder / "pictures", kMaxPictureBytes),
      textures(folder.empty() ? folder : folder / "textures", kMaxLevelBytes)
{
}

std::optional<KeptTextures::Picture> KeptTextures::find(const ContentHash& encoded)
{
    if (const auto found = known.find(encoded.hex()); found != known.end())
        return found->second;
    auto kept = pictures.open(pictureKey(encoded));
    PictureRecord record = {};
    if (!kept || !kept->read(std::as_writable_bytes(std::span(&record, 1))) || !kept->isIntact())
        return std::nullopt;
    return known
        .emplace(encoded.hex(), Picture{.image = {record.width, record.height, static_cast<TexelFormat>(record.format)},
                                        .facts = {.least = record.least, .greatest = record.greatest}})
        .first->second;
}

void KeptTextures::keep(const ContentHash& encoded, const Picture& picture)
{
    if (!known.emplace(encoded.hex(), picture).second)
        return;
    const PictureRecord record = {.width = picture.image.width,
                                  .height = picture.image.height,
                                  .format = static_cast<std::uint32_t>(picture.image.format),
                                  .unused = 0,
                                  .least = picture.facts.least,
                                  .greatest = picture.facts.greatest};
    pictures.store(pictureKey(encoded), std::as_bytes(std::span(&record, 1)));
}

std::optional<MappedFile> KeptTextures::mapLevels(const ContentHash& key) const
{
    auto kept = textures.open(key);
    return kept ? kept->map() : std::nullopt;
}

bool KeptTextures::readLevels(const ContentHash& key, std::span<std::byte> memory) const
{
    auto kept = textures.open(key);
    return kept && kept->read(memory) && kept->isIntact();
}

void KeptTextures::keepLevels(const ContentHash& key, std::span<const std::byte> memory)
{
    textures.store(key, memory);
}

std::vector<TexelFacts> texelFacts(const Scene& scene, std::span<const ContentHash> encoded, KeptTextures& kept)
{
    assert(encoded.empty() || encoded.size() == scene.images.size());
    std::vector<TexelFacts> facts;
    for (std::size_t i = 0; i < scene.images.size(); ++i) {
        const TextureImage& image = scene.images[i];
        if (image.texels.empty()) {
            facts.push_back(kept.find(encoded[i])->facts);
            continue;
        }
        facts.push_back(texelFacts(image));
        if (!encoded.empty())
            kept.keep(encoded[i], {{image.width, image.height, image.format}, facts.back()});
    }
    return facts;
}

std::optional<ContentHash> levelsKey(const PlannedTexture& texture, std::span<const ContentHash> encoded,
                                     int finestLevel, std::span<const std::size_t> layout)
{
    if (encoded.empty())
        return std::nullopt;
    ContentHasher hasher;
    hasher.add(kLevelsVersion).add(texture.content).add(texture.weighByAlpha).add(texture.lengthInAlpha);
    hasher.add(texture.width).add(texture.height).add(texture.sampler.mip != MipFilter::none).add(finestLevel);
    for (const ChannelSource& source : sourcesOf(texture)) {
        const ContentHash picture = source.image < 0 ? ContentHash{} : encoded[static_cast<std::size_t>(source.image)];
        hasher.add(picture.high).add(picture.low).add(source.channel);
    }
    return hasher.add(std::as_bytes(layout)).finish();
}

} // namespace torrance
