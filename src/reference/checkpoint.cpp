#include "reference/checkpoint.h"

#include "core/atomic_write.h"
#include "core/error.h"
#include "core/read_file.h"
#include "scene/scene_hash.h"

#include <cstring>
#include <span>

namespace torrance {
namespace {

// Before the payload: what the file is, what it was made from, and whether it is whole.
struct Header
{
    char magic[16];
    ContentHash inputs;
    ContentHash payload;
};
static_assert(sizeof(Header) == 48);

constexpr char kMagic[16] = "torrance part 1"; // the number changes with what follows

template <typename T>
void append(std::vector<std::byte>& bytes, const std::vector<T>& items)
{
    const auto view = std::as_bytes(std::span(items));
    bytes.insert(bytes.end(), view.begin(), view.end());
}

template <typename T>
void take(std::span<const std::byte>& bytes, std::vector<T>& items)
{
    std::memcpy(items.data(), bytes.data(), items.size() * sizeof(T));
    bytes = bytes.subspan(items.size() * sizeof(T));
}

std::size_t payloadSize(const ReferencePicture& picture)
{
    return picture.finished.size() + sizeof(float) * (picture.color.texels.size() + picture.variance.texels.size() +
                                                      picture.directions.texels.size());
}

} // namespace

ContentHash hashOfInputs(const Scene& scene, const Camera& camera, const ReferenceSettings& settings,
                         std::string_view program)
{
    const auto& [methods, physics, transport, width, height, pixelSamples, directions, targetError, maxDirections,
                 background, choice, seed, levelBias] = settings;
    ContentHasher hasher;
    hasher.add(program)
        .add(physics)
        .add(transport)
        .add(width)
        .add(height)
        .add(pixelSamples)
        .add(directions)
        .add(maxDirections)
        .add(choice)
        .add(seed);
    hasher.add(targetError.value_or(0.0));
    hasher.add(levelBias.has_value()).add(levelBias.value_or(0.0));
    hasher.add(background.has_value());
    const dvec4 color = background.value_or(dvec4(0.0));
    hasher.add(std::as_bytes(std::span(&color, 1)));
    for (const brdf::Slot slot : brdf::allSlots())
        hasher.add(methods[slot] ? methods[slot]->id : std::string_view());
    const auto& [doubleFresnel, noCosine, piDenominator, energySketch, fiveLevels, fresnelAtView, ambient,
                 specularFactor, reflectivity, reflection, fresnelExponent, refraction] = methods.options;
    hasher.add(doubleFresnel).add(noCosine).add(piDenominator).add(energySketch).add(fiveLevels).add(fresnelAtView);
    hasher.add(ambient).add(specularFactor).add(reflectivity);
    hasher.add(reflection).add(fresnelExponent).add(refraction);
    addToHash(hasher, camera);
    addToHash(hasher, scene);
    return hasher.finish();
}

void writeCheckpoint(const std::filesystem::path& path, const ReferencePicture& picture, const ContentHash& inputs)
{
    std::vector<std::byte> bytes(sizeof(Header));
    append(bytes, picture.finished);
    append(bytes, picture.color.texels);
    append(bytes, picture.variance.texels);
    append(bytes, picture.directions.texels);
    Header header{{}, inputs, hashBytes(std::span(bytes).subspan(sizeof(Header)))};
    std::memcpy(header.magic, kMagic, sizeof kMagic);
    std::memcpy(bytes.data(), &header, sizeof header);
    writeFile(path, bytes);
}

ReferencePicture readCheckpoint(const std::filesystem::path& path, const ReferenceSettings& settings,
                                const ContentHash& inputs)
{
    const std::vector<std::byte> bytes = readFile(path);
    ReferencePicture picture = emptyReference(settings.width, settings.height);
    Header header{};
    if (bytes.size() >= sizeof header)
        std::memcpy(&header, bytes.data(), sizeof header);
    if (std::memcmp(header.magic, kMagic, sizeof kMagic) != 0)
        throw inputError(path.string(), "", "is no checkpoint of this program", "delete it, or leave out --resume");
    if (header.inputs != inputs)
        throw inputError(path.string(), "", "was made from another scene, other options or another build",
                         "repeat the command that made it, or delete it");
    std::span<const std::byte> payload = std::span(bytes).subspan(sizeof header);
    if (payload.size() != payloadSize(picture) || hashBytes(payload) != header.payload)
        throw inputError(path.string(), "", "is damaged", "delete it, and begin anew");
    take(payload, picture.finished);
    take(payload, picture.color.texels);
    take(payload, picture.variance.texels);
    take(payload, picture.directions.texels);
    return picture;
}

} // namespace torrance
