#include "prepare/environment_maps.h"

#include "brdf/ggx_levels.h"
#include "brdf/phong_levels.h"
#include "prepare/ggx_prefilter.h"
#include "prepare/irradiance.h"
#include "prepare/phong_prefilter.h"
#include "prepare/radiance_cube.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <utility>

namespace torrance {
namespace {

/// A panorama as its light is summed: level 0 and both parts of it.
struct Light
{
    CubeLevels levels; // level 0 alone
    CubeTree base, excess;
};

Light lightOf(const Image& panorama, int size)
{
    assert(panorama.channels == 3 && panorama.width >= 1 && panorama.height >= 1);
    assert(std::all_of(panorama.texels.begin(), panorama.texels.end(),
                       [](float x) { return x >= 0.0f && std::isfinite(x); }));
    RadianceCube cube = makeRadianceCube(panorama, size);
    return {{size, 1, {std::move(cube.radiance)}},
            buildCubeTree(size, std::move(cube.base)),
            buildCubeTree(size, std::move(cube.excess))};
}

/// `levelOf` gives the faces of a level above 0, of so many texels a side.
template <typename LevelOf>
EnvironmentMaps mapsOf(const Image& panorama, int size, int levels, const LevelOf& levelOf)
{
    Light light = lightOf(panorama, size);
    CubeLevels specular = std::move(light.levels);
    specular.levels = levels;
    for (int level = 1; level < levels; ++level)
        specular.data.push_back(levelOf(light, level, specular.sizeOf(level)));
    return {std::move(specular), {kIrradianceSize, 1, {irradianceFaces(light.base, light.excess, kIrradianceSize)}}};
}

} // namespace

double levelAlpha(int level, int levels)
{
    return (std::pow(101.0, static_cast<double>(level) / (levels - 1)) - 1.0) / 100.0;
}

double alphaLevel(double alpha, int levels)
{
    return (levels - 1) * std::log2(1.0 + 100.0 * alpha) / std::log2(101.0);
}

int cubeSizeFor(int panoramaWidth)
{
    const auto quarter = static_cast<unsigned>((std::min(panoramaWidth, 4 * kGreatestCubeSize) + 3) / 4);
    return std::max(static_cast<int>(std::bit_ceil(quarter)), kLeastCubeSize);
}

int drawnCubeSize(int panoramaWidth, int directions)
{
    const int size = cubeSizeFor(panoramaWidth);
    return directions < kManyDirections ? size : std::min(2 * size, kGreatestCubeSize);
}

EnvironmentMaps makeEnvironmentMaps(const Image& panorama)
{
    const int size = cubeSizeFor(panorama.width);
    const int levels = std::countr_zero(static_cast<unsigned>(size / kLastLevelSize)) + 1;
    return mapsOf(panorama, size, levels, [levels](const Light& light, int level, int side) {
        return prefilterLevel(light.base, light.excess, side, levelAlpha(level, levels));
    });
}

EnvironmentMaps makePhongMaps(const Image& panorama)
{
    return mapsOf(panorama, kSourceCubeSize, brdf::kPhongLevels, [](const Light& light, int level, int side) {
        return phongLevel(light.base, light.excess, side, brdf::phongLevelExponent(level));
    });
}

EnvironmentMaps makeGgxLevelMaps(const Image& panorama)
{
    return mapsOf(panorama, kSourceCubeSize, brdf::kGgxLevels, [](const Light& light, int level, int side) {
        return prefilterLevel(light.base, light.excess, side, brdf::ggxLevelAlpha(level));
    });
}

} // namespace torrance
