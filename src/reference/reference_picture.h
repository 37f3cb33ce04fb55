// A whole reference picture, tile by tile on all cores.
#pragma once

#include "image/image.h"
#include "reference/pixel_estimate.h"

#include <functional>

namespace torrance {

/// What is known of a picture so far.
struct ReferencePicture
{
    Image color;                        // RGBA, scene-linear, premultiplied
    Image variance;                     // RGB, of the mean
    Image directions;                   // drawn per pixel
    std::vector<std::uint8_t> finished; // per tile: 1 where its pixels are there
};

/// Pixels along the side of a tile.
inline constexpr int kTileSide = 8;

ReferencePicture emptyReference(int width, int height);

struct ReferenceWatch
{
    /// Called after every tile, by one thread at a time; the picture does not change meanwhile.
    std::function<void(const ReferencePicture& picture, std::size_t done, std::size_t all)> tileDone;
    /// Asked before every pixel, by any thread: true ends the work, and tiles that were begun stay unfinished.
    std::function<bool()> stop;
};

/// Computes the tiles that are not finished. What a tile holds depends neither on the others nor on threads, nor on
/// which were finished before. True when all are.
bool completeReference(const PixelEstimator& estimator, const ReferenceSettings& settings, ReferencePicture& picture,
                       const ReferenceWatch& watch);

} // namespace torrance
