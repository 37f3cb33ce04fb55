#include "make_assets/noise.h"
#include "make_assets/textures.h"

#include <array>
#include <tuple>

namespace torrance::assets {
namespace {

constexpr std::array<dvec3, 6> kChips = {dvec3(0.76, 0.43, 0.31), dvec3(0.24, 0.40, 0.42), dvec3(0.87, 0.68, 0.42),
                                         dvec3(0.42, 0.38, 0.36), dvec3(0.96, 0.94, 0.91), dvec3(0.66, 0.58, 0.52)};

struct Chip
{
    double cover; // 0 cement, 1 chip
    dvec3 color;
};

/// The chip of one layer at a place: cells of a Voronoi diagram, shrunk by a width of their own, some left out.
Chip chipAt(double u, double v, int cells, double sharpness, double share, std::uint32_t seed)
{
    const double bend = 0.35;
    const double x =
        u * cells + bend * (smoothNoise(u * cells * 2, v * cells * 2, cells * 2, cells * 2, seed + 7) - 0.5);
    const double y =
        v * cells + bend * (smoothNoise(u * cells * 2, v * cells * 2, cells * 2, cells * 2, seed + 8) - 0.5);
    const NearestPoints near = nearestPoints(x, y, cells, seed);
    const double chance = randomValue(near.cellX, near.cellY, seed + 2);
    const double gap = 0.06 + 0.16 * randomValue(near.cellX, near.cellY, seed + 3);
    const auto kind = static_cast<std::size_t>(randomValue(near.cellX, near.cellY, seed + 4) * kChips.size());
    const double shade = 0.92 + 0.16 * randomValue(near.cellX, near.cellY, seed + 5);
    const double cover = chance < share ? glm::clamp((near.edge - gap) * sharpness, 0.0, 1.0) : 0.0;
    return {cover, kChips[kind] * shade};
}

} // namespace

Image terrazzoColor(int size)
{
    return makePicture(size, size, 3, [size](double u, double v) {
        const double cloud = cloudNoise(u * 6, v * 6, 6, 6, 11) - 0.5;
        const double grain = cloudNoise(u * 150, v * 150, 150, 150, 12) - 0.5;
        dvec3 color = dvec3(0.885, 0.865, 0.83) + dvec3(0.03 * cloud + 0.05 * grain);
        for (const auto& [cells, share, seed] : {std::tuple(38, 0.45, 31u), {18, 0.55, 21u}, {9, 0.42, 41u}}) {
            const Chip chip = chipAt(u, v, cells, 0.8 * size / cells, share, seed);
            color = glm::mix(color, chip.color + dvec3(0.06 * grain), chip.cover);
        }
        return dvec4(color, 1.0);
    });
}

} // namespace torrance::assets
