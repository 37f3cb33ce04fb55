#include "brdf/pixel_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace torrance::brdf {
namespace {

// A surface near a pixel, as the plane that its depths there suggest.
struct Plane
{
    double depth; // at `center`; 0: nothing is there
    dvec2 slope;  // per pixel
    dvec2 center; // pixels from this pixel's centre
    dvec4 color;

    double at(const dvec2& place) const { return depth + glm::dot(slope, place - center); }
};

// A line of depths from a pixel outwards: how much it changes with the first step, and how straight it goes on.
struct Side
{
    double slope; // per pixel away
    double bend;
};

Side sideOf(double here, double first, double second)
{
    if (first == 0.0)
        return {0.0, std::numeric_limits<double>::infinity()};
    // What has no second pixel should lie flat.
    return {first - here, std::abs(second == 0.0 ? first - here : here - 2.0 * first + second)};
}

// Depth's change per pixel along a line of five about the middle: on the side that is straighter.
double slopeOf(const std::array<double, 5>& line)
{
    const Side back = sideOf(line[2], line[1], line[0]), on = sideOf(line[2], line[3], line[4]);
    return back.bend < on.bend ? -back.slope : on.slope;
}

std::vector<Plane> planesAround(const PixelQuery& query)
{
    std::vector<Plane> planes;
    for (std::size_t i = 0; i < query.colors.size(); ++i) {
        const std::size_t column = i % 3 + 2, row = i / 3 + 2; // among the 7 x 7
        const auto depth = [&](std::size_t x, std::size_t y) { return query.depths[7 * y + x]; };
        std::array<double, 5> across = {}, down = {};
        for (std::size_t k = 0; k < 5; ++k) {
            across[k] = depth(column + k - 2, row);
            down[k] = depth(column, row + k - 2);
        }
        planes.push_back({depth(column, row),
                          {slopeOf(across), slopeOf(down)},
                          dvec2(double(column) - 3.0, double(row) - 3.0),
                          query.colors[i]});
    }
    return planes;
}

bool isFlat(const PixelQuery& query)
{
    const double center = query.depths[24];
    const auto& z = query.sampleDepths;
    if (center == 0.0)
        return std::ranges::all_of(z, [](double depth) { return depth == 0.0; });
    // Opposite samples' mean is the centre's depth on a plane.
    const double bend = std::max(std::abs(0.5 * (z[0] + z[3]) - center), std::abs(0.5 * (z[1] + z[2]) - center));
    return bend <= kPixelFlatness * query.widthInDepth(center);
}

dvec4 colorOfSample(const PixelQuery& query, const std::vector<Plane>& planes, std::size_t sample)
{
    const double depth = query.sampleDepths[sample];
    double best = std::numeric_limits<double>::infinity();
    dvec4 color = query.colors[4];
    for (const Plane& plane : planes) {
        if ((plane.depth > 0.0) != (depth > 0.0))
            continue; // a surface is not the background
        const dvec2 step = kSamplePlaces[sample] - plane.center;
        const double off =
            depth > 0.0 ? std::abs(plane.at(kSamplePlaces[sample]) - depth) / query.widthInDepth(depth) : 0.0;
        const double score = off + kPixelFlatness * glm::dot(step, step);
        if (score < best) {
            best = score;
            color = plane.color;
        }
    }
    return color;
}

} // namespace

dvec4 PS_supersampled(const PixelQuery& query)
{
    const auto count = static_cast<double>(query.sampleColors.size());
    return std::accumulate(query.sampleColors.begin(), query.sampleColors.end(), dvec4(0.0)) / count;
}

dvec4 PS_reconstructed(const PixelQuery& query)
{
    if (isFlat(query))
        return query.colors[4];
    const std::vector<Plane> planes = planesAround(query);
    dvec4 sum(0.0);
    for (std::size_t sample = 0; sample < kSamplePlaces.size(); ++sample)
        sum += colorOfSample(query, planes, sample);
    return sum / double(kSamplePlaces.size());
}

} // namespace torrance::brdf
