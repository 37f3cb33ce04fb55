#include "make_assets/shapes.h"

#include <algorithm>
#include <cmath>

namespace torrance::assets {
namespace {

/// The profile at a length, between its two neighbours.
ProfilePoint along(const Profile& profile, double length)
{
    const auto above = std::lower_bound(profile.begin() + 1, profile.end() - 1, length,
                                        [](const ProfilePoint& p, double x) { return p.length < x; });
    const ProfilePoint& b = *above;
    const ProfilePoint& a = *(above - 1);
    const double t = std::clamp((length - a.length) / (b.length - a.length), 0.0, 1.0);
    return {glm::mix(a.point, b.point, t), glm::normalize(glm::mix(a.normal, b.normal, t)), length};
}

} // namespace

Surface lathe(const Profile& profile, int columns)
{
    const double total = profile.back().length;
    const auto at = [profile, total](double u, double v) {
        const ProfilePoint place = along(profile, (1.0 - v) * total);
        const double turn = 2.0 * kPi * u;
        const dvec3 outward(std::sin(turn), 0.0, std::cos(turn));
        const dvec3 up(0.0, 1.0, 0.0);
        return SurfacePoint{outward * place.point.x + up * place.point.y,
                            outward * place.normal.x + up * place.normal.y, dvec3(std::cos(turn), 0.0, -std::sin(turn)),
                            dvec2(u, v)};
    };
    std::vector<double> rows;
    for (auto point = profile.rbegin(); point != profile.rend(); ++point)
        if (rows.empty() || 1.0 - point->length / total > rows.back())
            rows.push_back(1.0 - point->length / total);
    return {at, evenSteps(columns), rows};
}

} // namespace torrance::assets
