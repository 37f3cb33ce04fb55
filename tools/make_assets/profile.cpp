#include "make_assets/shapes.h"

#include <algorithm>
#include <cmath>

namespace torrance::assets {
namespace {

/// To the right of the way the curve goes: outwards for one that goes up the outside.
dvec2 outward(const dvec2& direction)
{
    return glm::normalize(dvec2(direction.y, -direction.x));
}

void addPoint(Profile& profile, const dvec2& point, const dvec2& normal)
{
    const double length = profile.empty() ? 0.0 : profile.back().length + glm::length(point - profile.back().point);
    profile.push_back({point, normal, length});
}

/// The span from b to c of the curve through a, b, c, d, by Barry and Goldman's pyramid.
dvec2 catmullRom(const dvec2& a, const dvec2& b, const dvec2& c, const dvec2& d, double t)
{
    const double t0 = 0.0;
    const double t1 = t0 + std::sqrt(glm::length(b - a));
    const double t2 = t1 + std::sqrt(glm::length(c - b));
    const double t3 = t2 + std::sqrt(glm::length(d - c));
    const double x = t1 + t * (t2 - t1);
    const auto blend = [x](const dvec2& p, const dvec2& q, double from, double to) {
        return p + (q - p) * ((x - from) / (to - from));
    };
    const dvec2 ab = blend(a, b, t0, t1);
    const dvec2 bc = blend(b, c, t1, t2);
    const dvec2 cd = blend(c, d, t2, t3);
    return blend(blend(ab, bc, t0, t2), blend(bc, cd, t1, t3), t1, t2);
}

void addArc(Profile& profile, const dvec2& before, const dvec2& corner, const dvec2& after, double radius, int steps)
{
    const dvec2 in = glm::normalize(corner - before);
    const dvec2 out = glm::normalize(after - corner);
    const double turn = std::atan2(in.x * out.y - in.y * out.x, glm::dot(in, out));
    const double cut = radius * std::tan(std::abs(turn) / 2.0);
    const double bulge = turn > 0.0 ? radius : -radius; // the arc's middle lies on the side it turns to
    const dvec2 start = corner - in * cut;
    const dvec2 middle = start - outward(in) * bulge;
    for (int i = 0; i <= steps; ++i) {
        const double angle = turn * i / steps;
        const dvec2 normal(outward(in).x * std::cos(angle) - outward(in).y * std::sin(angle),
                           outward(in).x * std::sin(angle) + outward(in).y * std::cos(angle));
        addPoint(profile, middle + normal * bulge, normal);
    }
}

} // namespace

Profile smoothProfile(const std::vector<dvec2>& points, int stepsPerSpan)
{
    const std::size_t last = points.size() - 1;
    const dvec2 beforeFirst = 2.0 * points[0] - points[1];
    const dvec2 afterLast = 2.0 * points[last] - points[last - 1];
    Profile profile;
    for (std::size_t span = 0; span < last; ++span) {
        const dvec2& a = span > 0 ? points[span - 1] : beforeFirst;
        const dvec2& d = span + 2 <= last ? points[span + 2] : afterLast;
        for (int i = span == 0 ? 0 : 1; i <= stepsPerSpan; ++i) {
            constexpr double kStep = 1e-4;
            const double t = static_cast<double>(i) / stepsPerSpan;
            const auto at = [&](double x) { return catmullRom(a, points[span], points[span + 1], d, x); };
            addPoint(profile, at(t), outward(at(std::min(t + kStep, 1.0)) - at(std::max(t - kStep, 0.0))));
        }
    }
    return profile;
}

Profile roundedProfile(const std::vector<dvec2>& points, double radius, int stepsPerCorner)
{
    Profile profile;
    addPoint(profile, points.front(), outward(points[1] - points[0]));
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        addArc(profile, points[i - 1], points[i], points[i + 1], radius, stepsPerCorner);
    addPoint(profile, points.back(), outward(points.back() - points[points.size() - 2]));
    return profile;
}

} // namespace torrance::assets
