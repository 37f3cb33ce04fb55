#include "reference/environment_sampler.h"

#include "core/huge_pages.h"
#include "math/guided_choice.h"
#include "math/latlong.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace torrance {
namespace {

/// Rotation about +Y, counter-clockwise seen from above.
dmat3 turned(double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return {dvec3(c, 0.0, -s), dvec3(0.0, 1.0, 0.0), dvec3(s, 0.0, c)};
}

/// A point of [-1, 1] of density 1 - |x|.
double triangular(double u)
{
    return u < 0.5 ? std::sqrt(2.0 * u) - 1.0 : 1.0 - std::sqrt(2.0 * (1.0 - u));
}

int shiftOfTiles(int width)
{
    int shift = 0;
    while ((width - 1) >> shift >= EnvironmentSampler::kMostTilesAcross)
        ++shift;
    return shift;
}

} // namespace

EnvironmentSampler::EnvironmentSampler(const Environment& environment)
    : width(environment.radiance.width), height(environment.radiance.height), tileShift(shiftOfTiles(width)),
      tilesAcross(((width - 1) >> tileShift) + 1), tilesDown(((height - 1) >> tileShift) + 1),
      intensity(environment.intensity), worldFromEnvironment(turned(environment.rotation))
{
    fill(environment.radiance);
    shapeTiles();
    if (intensity > 0.0)
        even = weighed(std::vector<double>(tileShapes.size(), 1.0));
}

void EnvironmentSampler::fill(const Image& radiance)
{
    const std::size_t side = std::size_t(1) << tileShift, tiles = std::size_t(tilesAcross) * std::size_t(tilesDown);
    resizeLarge(texels, tiles * side * side);
    for (int y = 0; y < height; ++y) {
        const double sine = std::sin(kPi * (y + 0.5) / height);
        for (int x = 0; x < width; ++x) {
            const float* rgb = radiance.at(x, y);
            const double luminance = (double(rgb[0]) + double(rgb[1]) + double(rgb[2])) / 3.0;
            texels[placeOf(x, y).texel] = {rgb[0], rgb[1], rgb[2], static_cast<float>(luminance * sine)};
        }
    }
    resizeLarge(columns, texels.size());
    rows.resize(tiles * side);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        double sum = 0.0;
        for (std::size_t i = row * side; i < (row + 1) * side; ++i)
            columns[i] = sum += static_cast<double>(texels[i].weight);
        rows[row] = (row % side == 0 ? 0.0 : rows[row - 1]) + sum;
    }
}

void EnvironmentSampler::shapeTiles()
{
    const int side = 1 << tileShift;
    const auto directionAt = [&](double x, double y) {
        return worldFromEnvironment * directionFromLatLong({x / width, std::clamp(y / height, 0.0, 1.0)});
    };
    for (int y = 0; y < height; y += side)
        for (int x = 0; x < width; x += side) {
            const double right = std::min(x + side, width), bottom = std::min(y + side, height);
            const dvec3 center = directionAt(0.5 * (x + right), 0.5 * (y + bottom));
            // A texel moves by one at most, from its centre. The farthest of a patch are its corners, unless it is
            // wider than half a turn.
            double radius = right - x + 1.0 > 0.5 * width ? kPi : 0.0;
            for (const double cornerX : {x - 0.5, right + 0.5})
                for (const double cornerY : {y - 0.5, bottom + 0.5})
                    radius = std::max(
                        radius, std::acos(std::clamp(glm::dot(center, directionAt(cornerX, cornerY)), -1.0, 1.0)));
            const double solidAngle =
                2.0 * kPi / width * (right - x) * (std::cos(kPi * y / height) - std::cos(kPi * bottom / height));
            tileShapes.push_back({vec3(center), static_cast<float>(radius), static_cast<float>(solidAngle)});
        }
}

EnvironmentSampler::Distribution EnvironmentSampler::weighed(std::vector<double> importance) const
{
    const std::size_t side = std::size_t(1) << tileShift;
    Distribution d;
    d.importance = std::move(importance);
    d.across.resize(tileShapes.size());
    d.down.resize(static_cast<std::size_t>(tilesDown));
    for (std::size_t row = 0, tile = 0; row < d.down.size(); ++row) {
        double sum = 0.0;
        for (int column = 0; column < tilesAcross; ++column, ++tile)
            d.across[tile] = sum += d.importance[tile] * rows[(tile + 1) * side - 1];
        d.down[row] = d.total += sum;
    }
    return d;
}

DirectedLight EnvironmentSampler::at(const dvec3& direction, const Distribution& distribution) const
{
    const dvec3 local = direction * worldFromEnvironment; // times the transpose: the inverse of a rotation
    const dvec2 place = latLongFromDirection(local) * dvec2(width, height) - 0.5;
    const double column = std::floor(place.x), row = std::floor(place.y);
    const double fx = place.x - column, fy = place.y - row;
    const int x0 = (static_cast<int>(column) + width) % width, x1 = x0 + 1 == width ? 0 : x0 + 1;
    const int y0 = std::clamp(static_cast<int>(row), 0, height - 1),
              y1 = std::min(static_cast<int>(row) + 1, height - 1);
    const std::array places = {placeOf(x0, y0), placeOf(x1, y0), placeOf(x0, y1), placeOf(x1, y1)};
    const std::array parts = {(1.0 - fy) * (1.0 - fx), (1.0 - fy) * fx, fy * (1.0 - fx), fy * fx};
    const double sine = std::sqrt(local.x * local.x + local.z * local.z);
    DirectedLight light;
    double weight = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Texel& texel = texels[places[i].texel];
        light.radiance += parts[i] * dvec3(texel.r, texel.g, texel.b);
        if (!distribution.importance.empty())
            weight += parts[i] * distribution.importance[places[i].tile] * double(texel.weight);
    }
    light.radiance *= intensity;
    if (weight > 0.0) // solid angle = 2 pi^2 sin(theta) du dv
        light.density = weight * double(width) * double(height) / (distribution.total * 2.0 * kPi * kPi * sine);
    return light;
}

dvec3 EnvironmentSampler::draw(const dvec2& u, const Distribution& distribution) const
{
    assert(distribution.usable());
    const std::size_t side = std::size_t(1) << tileShift;
    const auto tilesInRow = static_cast<std::size_t>(tilesAcross);
    const IntervalChoice tileRow = choose(distribution.down, u.y);
    const IntervalChoice tileColumn =
        choose(std::span(distribution.across).subspan(tileRow.index * tilesInRow, tilesInRow), u.x);
    const std::size_t tile = tileRow.index * tilesInRow + tileColumn.index;
    const IntervalChoice row = choose(std::span(rows).subspan(tile * side, side), tileRow.rest);
    const IntervalChoice column =
        choose(std::span(columns).subspan((tile * side + row.index) * side, side), tileColumn.rest);
    const double x = static_cast<double>(tileColumn.index * side + column.index) + 0.5 + triangular(column.rest);
    const double y =
        (static_cast<double>(tileRow.index * side + row.index) + 0.5 + triangular(row.rest)) / double(height);
    return worldFromEnvironment * directionFromLatLong({x / double(width), y < 0.0 ? -y : y > 1.0 ? 2.0 - y : y});
}

} // namespace torrance
