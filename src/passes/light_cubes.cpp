#include "passes/light_cubes.h"

#include <cstring>
#include <span>

namespace torrance {
namespace {

/// A way of making maps. The version changes whenever it would give other numbers for the same panorama, and is never
/// another's.
struct Maker
{
    EnvironmentMaps (*make)(const Image& panorama);
    int version;
};

Maker makerFor(const brdf::Method& specular)
{
    if (specular.id == "phong_levels")
        return {&makePhongMaps, 0x10001};
    if (specular.id == "ggx_levels")
        return {&makeGgxLevelMaps, 0x20001};
    return {&makeEnvironmentMaps, 2};
}

void append(std::vector<float>& out, const CubeLevels& cube)
{
    out.push_back(static_cast<float>(cube.size));
    out.push_back(static_cast<float>(cube.levels));
    for (const std::vector<float>& level : cube.data)
        out.insert(out.end(), level.begin(), level.end());
}

// The checksum of the cache says that these are the numbers that were stored: no more needs to be tested here.
CubeLevels take(const std::vector<float>& numbers, std::size_t& at)
{
    CubeLevels cube = {
        .size = static_cast<int>(numbers.at(at)), .levels = static_cast<int>(numbers.at(at + 1)), .data = {}};
    at += 2;
    for (int level = 0; level < cube.levels; ++level) {
        const auto side = static_cast<std::size_t>(cube.size >> level);
        const std::size_t count = 6 * side * side * 4;
        const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(at);
        cube.data.emplace_back(first, first + static_cast<std::ptrdiff_t>(count));
        at += count;
    }
    return cube;
}

} // namespace

EnvironmentMaps cachedEnvironmentMaps(const brdf::Method& specular, const Image& radiance, const ContentHash& content,
                                      DiskCache& cache)
{
    const Maker maker = makerFor(specular);
    const ContentHash key = ContentHasher().add(content.high).add(content.low).add(maker.version).finish();
    if (const auto bytes = cache.load(key)) {
        std::vector<float> numbers(bytes->size() / sizeof(float));
        std::memcpy(numbers.data(), bytes->data(), numbers.size() * sizeof(float));
        std::size_t at = 0;
        CubeLevels specularLevels = take(numbers, at);
        return {.specular = std::move(specularLevels), .irradiance = take(numbers, at)};
    }
    EnvironmentMaps maps = maker.make(radiance);
    std::vector<float> numbers;
    append(numbers, maps.specular);
    append(numbers, maps.irradiance);
    cache.store(key, std::as_bytes(std::span(numbers)));
    return maps;
}

} // namespace torrance
