#include "files/polygon.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

/// In the plane of the two axes along which the polygon's shadow is largest, counter-clockwise.
std::vector<dvec2> flattened(std::span<const dvec3> corners, const dvec3& normal)
{
    const dvec3 size = glm::abs(normal);
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    std::vector<dvec2> flat;
    flat.reserve(corners.size());
    for (const dvec3& corner : corners) {
        const dvec3 p = corner - corners[0];
        flat.push_back(normal[axis] < 0.0 ? dvec2(p[v], p[u]) : dvec2(p[u], p[v]));
    }
    return flat;
}

/// Twice the area of abc: above 0 where they turn left.
double turn(const dvec2& a, const dvec2& b, const dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool isConvex(const std::vector<dvec2>& corners)
{
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i)
        if (turn(corners[i], corners[(i + 1) % n], corners[(i + 2) % n]) < 0.0)
            return false;
    return true;
}

class EarCutter
{
public:
    EarCutter(const std::vector<dvec2>& flat, CuttingBudget& limit)
        : corners(flat), budget(limit), before(flat.size()), after(flat.size())
    {
        const auto n = static_cast<std::uint32_t>(flat.size());
        for (std::uint32_t i = 0; i < n; ++i) {
            before[i] = (i + n - 1) % n;
            after[i] = (i + 1) % n;
        }
    }

    bool cut(std::vector<std::uint32_t>& triangles)
    {
        std::uint32_t at = 0;
        std::size_t left = corners.size();
        for (std::size_t sinceCut = 0; left > 3;) {
            const bool isForced = sinceCut == left; // no ear anywhere: the outline crosses or touches itself
            if (!isForced && !isEar(at)) {
                if (budget.tests == 0)
                    return false;
                at = after[at];
                ++sinceCut;
                continue;
            }
            triangles.insert(triangles.end(), {before[at], at, after[at]});
            after[before[at]] = after[at];
            before[after[at]] = before[at];
            at = after[at];
            --left;
            sinceCut = 0;
        }
        triangles.insert(triangles.end(), {before[at], at, after[at]});
        return true;
    }

private:
    /// A corner that turns left and whose triangle holds no other corner. Those that lie on one of its corners do not
    /// count: an outline that leads into a hole and back passes through the same points twice.
    bool isEar(std::uint32_t at)
    {
        const dvec2 &a = corners[before[at]], &b = corners[at], &c = corners[after[at]];
        if (turn(a, b, c) <= 0.0)
            return false;
        for (std::uint32_t i = after[after[at]]; i != before[at]; i = after[i]) {
            if (budget.tests == 0)
                return false;
            --budget.tests;
            const dvec2& p = corners[i];
            if (p != a && p != b && p != c && turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0)
                return false;
        }
        return true;
    }

    const std::vector<dvec2>& corners;
    CuttingBudget& budget;
    std::vector<std::uint32_t> before, after;
};

} // namespace

dvec3 newellVector(std::span<const dvec3> corners)
{
    dvec3 sum(0.0);
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    return sum;
}

bool triangulate(std::span<const dvec3> corners, std::vector<std::uint32_t>& triangles, CuttingBudget& budget)
{
    if (corners.size() == 3) {
        triangles.insert(triangles.end(), {0, 1, 2});
        return true;
    }
    const std::vector<dvec2> flat = flattened(corners, newellVector(corners));
    if (!isConvex(flat))
        return EarCutter(flat, budget).cut(triangles);
    if (corners.size() == 4 && glm::distance(corners[1], corners[3]) < glm::distance(corners[0], corners[2])) {
        triangles.insert(triangles.end(), {0, 1, 3, 1, 2, 3});
        return true;
    }
    for (std::uint32_t i = 2; i < corners.size(); ++i)
        triangles.insert(triangles.end(), {0, i - 1, i});
    return true;
}

} // namespace torrance
