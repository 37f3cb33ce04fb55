#include "make_assets/noise.h"
#include "make_assets/textures.h"

#include <algorithm>
#include <cmath>

namespace torrance::assets {
namespace {

constexpr int kDents = 11; // along each side of the tile

/// Height of the hammered sheet in tile widths: the lowest of the round dents about a place.
double dentHeight(double u, double v)
{
    const NearestPoints near = nearestPoints(u * kDents, v * kDents, kDents, 61);
    const double depth = 0.8 + 0.4 * randomValue(near.cellX, near.cellY, 63);
    return 0.14 / kDents * depth * (near.first * near.first + 0.10 * std::exp(-18.0 * near.edge));
}

} // namespace

Image hammeredNormal(int size)
{
    return makePicture(size, size, 3, [size](double u, double v) {
        const double step = 0.75 / size;
        const double slopeU = (dentHeight(u + step, v) - dentHeight(u - step, v)) / (2.0 * step);
        const double slopeV = (dentHeight(u, v + step) - dentHeight(u, v - step)) / (2.0 * step);
        // v runs down the picture; the map's green points up.
        const dvec3 normal = glm::normalize(dvec3(-slopeU, slopeV, 1.0));
        return dvec4(0.5 * normal + 0.5, 1.0);
    });
}

Image brushedRoughness(int size)
{
    return makePicture(size, size, 3, [](double u, double v) {
        const double broad = cloudNoise(u * 2, v * 60, 2, 60, 71);
        const double fine = smoothNoise(u * 10, v * 250, 10, 250, 72);
        return dvec4(0.0, 0.16 + 0.26 * broad + 0.16 * fine, 1.0, 1.0);
    });
}

Image perforatedAlpha(int size)
{
    return makePicture(size, size, 4, [size](double u, double v) {
        const double height = std::sqrt(3.0);
        const dvec2 place(u, v * height);
        double nearest = 2.0;
        for (const dvec2& hole :
             {dvec2(0.0, 0.0), dvec2(1.0, 0.0), dvec2(0.0, height), dvec2(1.0, height), dvec2(0.5, 0.5 * height)})
            nearest = std::min(nearest, glm::length(place - hole));
        // A ramp four texels wide about the edge, so that the cut at one half is smooth between texels.
        const double alpha = 0.5 + (nearest - 0.34) * size / 4.0;
        return dvec4(1.0, 1.0, 1.0, alpha);
    });
}

} // namespace torrance::assets
