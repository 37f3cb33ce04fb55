// Which pixels of a picture are looked at: a random sample of all that are covered, and some that are asked for.
#pragma once

#include "measure/ratio_estimate.h"
#include "reference/pixel_estimate.h"

#include <string>
#include <vector>

namespace torrance {

/// A pixel whose centre sees a surface.
struct CoveredPixel
{
    int x = 0, y = 0;
    int material = -1; // Scene::materials
    float NoV = 1.0f;  // of the triangle, or of the shape
};

/// Tile by tile, so that neighbours in the list are neighbours in the picture.
std::vector<CoveredPixel> coveredPixels(const PixelEstimator& estimator, int width, int height);

/// Consecutive pixels of the list, and those of them that were drawn.
struct PixelStratum
{
    std::size_t population = 0;
    std::vector<std::size_t> drawn; // numbers in the list, ascending
};

/// `count` of `population` pixels without replacement: strata of the same size up to one pixel, two pixels from each
/// (three from one where the count is odd), because two are the least that tell a stratum's spread (Cochran, Sampling
/// Techniques, 1977, section 5A.12 ff.). All, in one stratum, where there are no more than `count`. A pure function of
/// its arguments. count >= 2 or population <= count.
std::vector<PixelStratum> drawSample(std::size_t population, std::size_t count, std::uint64_t seed);

/// A pixel that is looked at whatever chance says.
struct ForcedPixel
{
    std::size_t pixel = 0; // in the list
    std::string why;
};

/// One of every material, at random; the brightest that was drawn; the most grazing that is seen. Some may be one
/// pixel. `drawn` is the picture.
std::vector<ForcedPixel> forcedPixels(const Scene& scene, const std::vector<CoveredPixel>& covered, const Image& drawn,
                                      std::uint64_t seed);

} // namespace torrance
