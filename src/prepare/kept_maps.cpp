#include "prepare/kept_maps.h"

namespace torrance {
namespace {

/// A way of making maps. The version changes whenever it would give other numbers for the same panorama, or is kept in
/// another form, and is never another's.
struct Maker
{
    EnvironmentMaps (*make)(const Image& panorama);
    int version;
};

Maker makerFor(const brdf::Method& specular)
{
    if (specular.id == "phong_levels")
        return {&makePhongMaps, 0x10002};
    if (specular.id == "ggx_levels")
        return {&makeGgxLevelMaps, 0x20002};
    return {&makeEnvironmentMaps, 3};
}

bool readLevels(KeptResult& kept, CubeLevels& cube)
{
    for (int level = 0; level < cube.levels; ++level) {
        const auto side = static_cast<std::size_t>(cube.sizeOf(level));
        cube.data.emplace_back(6 * side * side * 4);
        if (!kept.read(std::as_writable_bytes(std::span(cube.data.back()))))
            return false;
    }
    return true;
}

} // namespace

EnvironmentMaps makeMaps(const brdf::Method& specular, const Image& panorama)
{
    return makerFor(specular).make(panorama);
}

ContentHash panoramaContent(const Image& panorama)
{
    return ContentHasher()
        .add(panorama.width)
        .add(panorama.height)
        .add(std::as_bytes(std::span(panorama.texels)))
        .finish();
}

ContentHash mapsKey(const brdf::Method& specular, const ContentHash& panorama)
{
    return ContentHasher().add(panorama.high).add(panorama.low).add(makerFor(specular).version).finish();
}

KeptForm::KeptForm(const EnvironmentMaps& maps)
    : shape{static_cast<std::uint32_t>(maps.specular.size), static_cast<std::uint32_t>(maps.specular.levels),
            static_cast<std::uint32_t>(maps.irradiance.size), 0}
{
    list.push_back(std::as_bytes(std::span(&shape, 1)));
    for (const CubeLevels* cube : {&maps.specular, &maps.irradiance})
        for (const std::vector<float>& level : cube->data)
            list.push_back(std::as_bytes(std::span(level)));
}

std::optional<KeptShape> readShape(KeptResult& kept)
{
    constexpr std::uint32_t kGreatestSize = 4096, kMostLevels = 13;
    KeptShape shape = {};
    const bool plausible = kept.read(std::as_writable_bytes(std::span(&shape, 1))) && shape.size <= kGreatestSize &&
                           shape.levels >= 1 && shape.levels <= kMostLevels && shape.size >> (shape.levels - 1) >= 1 &&
                           shape.irradianceSize >= 1 && shape.irradianceSize <= kGreatestSize;
    return plausible ? std::optional(shape) : std::nullopt;
}

std::optional<EnvironmentMaps> readMaps(KeptResult kept)
{
    const auto shape = readShape(kept);
    if (!shape)
        return std::nullopt;
    EnvironmentMaps maps = {.specular = {static_cast<int>(shape->size), static_cast<int>(shape->levels), {}},
                            .irradiance = {static_cast<int>(shape->irradianceSize), 1, {}}};
    if (!readLevels(kept, maps.specular) || !readLevels(kept, maps.irradiance) || !kept.isIntact())
        return std::nullopt;
    return maps;
}

} // namespace torrance
