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
    const int ix = static_cast<int>(std::floor(x));
    const int iy = static_cast<int>(std::floor(y));
    NearestPoints result{std::numeric_limits<double>::max(), std::numeric_limits<double>::max(), 0, 0};
    dvec2 nearest(0.0);
    const auto visit = [&](const auto& see) {
        for (int dy = -2; dy <= 2; ++dy)
            for (int dx = -2; dx <= 2; ++dx)
                see(ix + dx, iy + dy, cellPoint(ix + dx, iy + dy, period, seed));
    };
    visit([&](int cx, int cy, const dvec2& point) {
        const double distance = glm::length(point - here);
        if (distance < result.first) {
            result = {distance, result.edge, wrap(cx, period), wrap(cy, period)};
            nearest = point;
        }
    });
    visit([&](int, int, const dvec2& point) {
        if (point != nearest) // distance to the line halfway between the two points
            result.edge =
                std::min(result.edge, glm::dot(0.5 * (nearest + point) - here, glm::normalize(point - nearest)));
    });
    return result;
}

} // namespace torrance::assets
