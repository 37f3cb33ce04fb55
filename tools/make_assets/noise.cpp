#include "make_assets/noise.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torrance::assets {
namespace {

int wrap(int x, int period)
{
    return ((x % period) + period) % period;
}

double fade(double t)
{
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

dvec2 cellPoint(int x, int y, int period, std::uint32_t seed)
{
    const int cx = wrap(x, period);
    const int cy = wrap(y, period);
    return dvec2(x + 0.1 + 0.8 * randomValue(cx, cy, seed), y + 0.1 + 0.8 * randomValue(cx, cy, seed + 1));
}

} // namespace

double randomValue(int x, int y, std::uint32_t seed)
{
    // A 32-bit mixer in the manner of PCG (O'Neill 2014): multiply, xor of a shifted self.
    std::uint32_t h =
        static_cast<std::uint32_t>(x) * 0x8da6b343u ^ static_cast<std::uint32_t>(y) * 0xd8163841u ^ seed * 0xcb1ab31fu;
    for (int round = 0; round < 2; ++round) {
        h = h * 747796405u + 2891336453u;
        h = ((h >> ((h >> 28) + 4)) ^ h) * 277803737u;
        h ^= h >> 22;
    }
    return h / 4294967296.0;
}

double smoothNoise(double x, double y, int periodX, int periodY, std::uint32_t seed)
{
    const int ix = static_cast<int>(std::floor(x));
    const int iy = static_cast<int>(std::floor(y));
    const auto corner = [&](int dx, int dy) {
        return randomValue(wrap(ix + dx, periodX), wrap(iy + dy, periodY), seed);
    };
    const double tx = fade(x - ix);
    const double ty = fade(y - iy);
    return glm::mix(glm::mix(corner(0, 0), corner(1, 0), tx), glm::mix(corner(0, 1), corner(1, 1), tx), ty);
}

double cloudNoise(double x, double y, int periodX, int periodY, std::uint32_t seed)
{
    double sum = 0.0;
    double weight = 0.5;
    for (std::uint32_t octave = 0; octave < 4; ++octave) {
        const int scale = 1 << octave;
        sum += weight * smoothNoise(x * scale, y * scale, periodX * scale, periodY * scale, seed + octave);
        weight *= 0.5;
    }
    return sum / (1.0 - weight * 2.0);
}

NearestPoints nearestPoints(double x, double y, int period, std::uint32_t seed)
{
    const dvec2 here(x, y);
    const auto visit = [&](int centreX, int centreY, const auto& see) {
        for (int cy = centreY - 1; cy <= centreY + 1; ++cy)
            for (int cx = centreX - 1; cx <= centreX + 1; ++cx)
                see(cx, cy, cellPoint(cx, cy, period, seed));
    };
    double squared = std::numeric_limits<double>::max();
    dvec2 nearest(0.0);
    ivec2 cell(0);
    visit(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)), [&](int cx, int cy, const dvec2& point) {
        const double candidate = glm::dot(point - here, point - here);
        if (candidate < squared) {
            squared = candidate;
            nearest = point;
            cell = ivec2(cx, cy);
        }
    });
    double edge = std::numeric_limits<double>::max();
    visit(cell.x, cell.y, [&](int cx, int cy, const dvec2& point) {
        if (ivec2(cx, cy) != cell) // distance to the line halfway between the two points
            edge = std::min(edge, glm::dot(0.5 * (nearest + point) - here, glm::normalize(point - nearest)));
    });
    return {std::sqrt(squared), edge, wrap(cell.x, period), wrap(cell.y, period)};
}

} // namespace torrance::assets
