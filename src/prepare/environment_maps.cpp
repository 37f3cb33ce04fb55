#include "prepare/environment_maps.h"

#include "prepare/ggx_prefilter.h"
#include "prepare/irradiance.h"
#include "prepare/radiance_cube.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <utility>

namespace torrance {

double levelAlpha(int level, int levels)
{
    return (std::pow(101.0, static_cast<double>(level) / (levels - 1)) - 1.0) / 100.0;
}

int cubeSizeFor(int panoramaWidth)
{
    const auto quarter = static_cast<unsigned>((std::min(panoramaWidth, 4 * kGreatestCubeSize) + 3) / 4);
    return std::max(static_cast<int>(std::bit_ceil(quarter)), kLeastCubeSize);
}

EnvironmentMaps makeEnvironmentMaps(const Image& panorama)
{
    assert(panorama.channels == 3 && panorama.width >= 1 && panorama.height >= 1);
    assert(std::all_of(panorama.texels.begin(), panorama.texels.end(),
                       [](float x) { return x >= 0.0f && std::isfinite(x); }));
    RadianceCube cube = makeRadianceCube(panorama, cubeSizeFor(panorama.width));
    const CubeTree base = buildCubeTree(cube.size, std::move(cube.base));
    const CubeTree excess = buildCubeTree(cube.size, std::move(cube.excess));

    EnvironmentMaps maps;
    maps.specular.size = cube.size;
    maps.specular.levels = std::countr_zero(static_cast<unsigned>(cube.size / kLastLevelSize)) + 1;
    maps.specular.data.push_back(std::move(cube.radiance));
    for (int level = 1; level < maps.specular.levels; ++level)
        maps.specular.data.push_back(
            prefilterLevel(base, excess, maps.specular.sizeOf(level), levelAlpha(level, maps.specular.levels)));
    maps.irradiance = {kIrradianceSize, 1, {irradianceFaces(base, excess, kIrradianceSize)}};
    return maps;
}

} // namespace torrance
