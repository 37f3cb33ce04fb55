#include "reference/reference_picture.h"

#include "core/parallel.h"

#include <algorithm>
#include <mutex>

namespace torrance {
namespace {

int tilesAcross(int side)
{
    return (side + kTileSide - 1) / kTileSide;
}

struct Tile
{
    int left, top, right, bottom;

    std::size_t pixels() const { return static_cast<std::size_t>((right - left) * (bottom - top)); }
};

Tile tileOf(const ReferenceSettings& settings, std::size_t index)
{
    const int across = tilesAcross(settings.width);
    const int left = static_cast<int>(index) % across * kTileSide, top = static_cast<int>(index) / across * kTileSide;
    return {left, top, std::min(left + kTileSide, settings.width), std::min(top + kTileSide, settings.height)};
}

void put(ReferencePicture& picture, int x, int y, const PixelEstimate& pixel)
{
    for (int c = 0; c < 4; ++c)
        picture.color.at(x, y)[c] = static_cast<float>(pixel.color[c]);
    for (int c = 0; c < 3; ++c)
        picture.variance.at(x, y)[c] = static_cast<float>(pixel.variance[c]);
    picture.directions.at(x, y)[0] = static_cast<float>(pixel.directions);
}

/// Mean |c|_1 of the covered pixels, from few directions each. Rows are added up in order, whoever computed them.
double pilotMeanNorm(const PixelEstimator& estimator, const ReferenceSettings& settings, const ReferenceWatch& watch)
{
    std::vector<dvec2> rows(static_cast<std::size_t>(settings.height)); // sum of |c|_1, sum of coverage
    parallelFor(rows.size(), 1, [&](std::size_t y) {
        for (int x = 0; x < settings.width && !watch.stop(); ++x) {
            const PixelEstimate pixel = estimator.pilot(x, static_cast<int>(y));
            if (pixel.covered > 0.0)
                rows[y] += dvec2(pixel.color.r + pixel.color.g + pixel.color.b, 1.0);
        }
    });
    dvec2 sum(0.0);
    for (const dvec2& row : rows)
        sum += row;
    return sum.y > 0.0 ? sum.x / sum.y : 0.0;
}

/// Row by row; fewer than the tile has where the work was ended.
std::vector<PixelEstimate> estimateTile(const PixelEstimator& estimator, const Tile& tile, double meanNorm,
                                        const ReferenceWatch& watch)
{
    std::vector<PixelEstimate> pixels;
    for (int y = tile.top; y < tile.bottom; ++y)
        for (int x = tile.left; x < tile.right; ++x) {
            if (watch.stop())
                return pixels;
            pixels.push_back(estimator.estimate(x, y, meanNorm));
        }
    return pixels;
}

void putTile(ReferencePicture& picture, const Tile& tile, const std::vector<PixelEstimate>& pixels)
{
    auto pixel = pixels.begin();
    for (int y = tile.top; y < tile.bottom; ++y)
        for (int x = tile.left; x < tile.right; ++x)
            put(picture, x, y, *pixel++);
}

} // namespace

ReferencePicture emptyReference(int width, int height)
{
    const auto tiles = static_cast<std::size_t>(tilesAcross(width)) * static_cast<std::size_t>(tilesAcross(height));
    return {Image(width, height, 4), Image(width, height, 3), Image(width, height, 1),
            std::vector<std::uint8_t>(tiles, 0)};
}

bool completeReference(const PixelEstimator& estimator, const ReferenceSettings& settings, ReferencePicture& picture,
                       const ReferenceWatch& watch)
{
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < picture.finished.size(); ++i)
        if (!picture.finished[i])
            open.push_back(i);
    const double meanNorm = settings.targetError && !open.empty() ? pilotMeanNorm(estimator, settings, watch) : 0.0;
    const std::size_t all = picture.finished.size();
    std::size_t done = all - open.size();
    std::mutex mutex;
    parallelFor(open.size(), 1, [&](std::size_t i) {
        const Tile tile = tileOf(settings, open[i]);
        const std::vector<PixelEstimate> pixels = estimateTile(estimator, tile, meanNorm, watch);
        if (pixels.size() < tile.pixels())
            return;
        const std::lock_guard lock(mutex);
        putTile(picture, tile, pixels);
        picture.finished[open[i]] = 1;
        watch.tileDone(picture, ++done, all);
    });
    return done == all;
}

} // namespace torrance
