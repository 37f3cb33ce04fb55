// The environment as the light that it is: radiance in every direction, and directions drawn from where it is bright.
#pragma once

#include "reference/directed_light.h"
#include "scene/scene.h"

#include <cstddef>
#include <span>
#include <vector>

namespace torrance {

/// Radiance is the bilinear interpolation of the panorama's texels, which stand for the directions of their centres:
/// periodic in u, constant beyond the first and the last row's centres. It is what the device draws behind the scene
/// and what its prefilter reads; suns included, which the prefilter spreads over their texel's area: the energy is the
/// same.
///
/// The density that directions are drawn from is, over (u, v), the bilinear interpolation of texel weights: luminance
/// (mean of the channels) times the sine of the row's polar angle, times the importance of the tile that the texel lies
/// in. A point is drawn exactly from it by taking a texel by its weight and moving by a triangular distribution,
/// mirrored at the poles.
class EnvironmentSampler
{
public:
    /// Copies what it needs. The picture's values are finite and not negative.
    explicit EnvironmentSampler(const Environment& environment);

    /// No light from anywhere: nothing can be drawn.
    bool dark() const { return !even.usable(); }

    /// The panorama is dealt out to square tiles, at most kMostTilesAcross in a row.
    static constexpr int kMostTilesAcross = 64;
    struct Tile
    {
        vec3 center;      // unit, in the world
        float radius;     // angle to what is farthest from it of all that is drawn by the tile's texels
        float solidAngle; // of its texels, sr
    };
    std::span<const Tile> tiles() const { return tileShapes; }

    /// A distribution over directions.
    class Distribution
    {
    public:
        /// Whether there is light that can be drawn by it.
        bool usable() const { return total > 0.0; }

    private:
        friend EnvironmentSampler;
        std::vector<double> importance; // by tile
        std::vector<double> across;     // by tile: running sums over the tiles of its row
        std::vector<double> down;       // running sums of the rows of tiles
        double total = 0.0;
    };

    /// One that is proportional to an importance, too: of tiles(), finite and not negative.
    Distribution weighed(std::vector<double> importance) const;
    /// By brightness alone.
    const Distribution& plain() const { return even; }

    /// `direction` is unit, in the world. The density is infinite at the poles.
    DirectedLight at(const dvec3& direction, const Distribution& distribution) const;
    DirectedLight at(const dvec3& direction) const { return at(direction, even); }

    /// A unit direction in the world, by a usable distribution.
    dvec3 draw(const dvec2& u, const Distribution& distribution) const;
    dvec3 draw(const dvec2& u) const { return draw(u, even); }

private:
    struct Texel
    {
        float r = 0.0f, g = 0.0f, b = 0.0f, weight = 0.0f;
    };
    struct Place
    {
        std::size_t tile, texel;
    };
    Place placeOf(int x, int y) const
    {
        const int mask = (1 << tileShift) - 1;
        const auto tile = static_cast<std::size_t>((y >> tileShift) * tilesAcross + (x >> tileShift));
        const auto inside = static_cast<std::size_t>((y & mask) << tileShift | (x & mask));
        return {tile, (tile << (2 * tileShift)) + inside};
    }
    void fill(const Image& radiance);
    void shapeTiles();

    int width = 0;
    int height = 0;
    int tileShift = 0; // the side of a tile is 2^tileShift texels
    int tilesAcross = 0;
    int tilesDown = 0;
    double intensity = 1.0;
    dmat3 worldFromEnvironment = dmat3(1.0);
    // Tile by tile, row by row: what is near on the sphere is near in memory. What of a tile lies beyond the picture
    // has no weight.
    std::vector<Texel> texels;
    std::vector<double> columns; // running sums of weights over a tile's row
    std::vector<double> rows;    // by tile and its row: running sums of whole rows
    std::vector<Tile> tileShapes;
    Distribution even;
};

} // namespace torrance
