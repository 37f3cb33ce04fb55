// Boxes along the axes.
#pragma once

#include "math/vector.h"

#include <limits>

namespace torrance {

/// Empty until something is included.
struct Box
{
    dvec3 least = dvec3(std::numeric_limits<double>::infinity());
    dvec3 greatest = dvec3(-std::numeric_limits<double>::infinity());

    void include(const dvec3& p)
    {
        least = glm::min(least, p);
        greatest = glm::max(greatest, p);
    }
    void include(const Box& box)
    {
        least = glm::min(least, box.least);
        greatest = glm::max(greatest, box.greatest);
    }
    bool empty() const { return least.x > greatest.x; }
    dvec3 corner(int number) const // 0 to 7
    {
        return {number & 1 ? greatest.x : least.x, number & 2 ? greatest.y : least.y,
                number & 4 ? greatest.z : least.z};
    }
};

/// The box round a transformed box.
inline Box transformed(const dmat4& m, const Box& box)
{
    Box result;
    for (int i = 0; i < 8; ++i)
        result.include(dvec3(m * dvec4(box.corner(i), 1.0)));
    return result;
}

} // namespace torrance
