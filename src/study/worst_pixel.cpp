#include "study/worst_pixel.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace torrance {
namespace {

std::string colorText(const dvec3& c)
{
    return fmt::format("({:.9g}, {:.9g}, {:.9g})", c.r, c.g, c.b);
}

} // namespace

double WorstExcess::note(int px, int py, const dvec3& drawnColor, const dvec3& exactColor, const dvec3& allowedError)
{
    double most = 0.0;
    for (int c = 0; c < 3; ++c) {
        const double error = std::abs(drawnColor[c] - exactColor[c]);
        // A NaN is worse than any number.
        const double ratio = std::isfinite(error) ? error / allowedError[c] : std::numeric_limits<double>::infinity();
        most = std::max(most, ratio);
    }
    if (most > excess)
        *this = {most, px, py, drawnColor, exactColor, allowedError};
    return most;
}

std::string WorstExcess::text() const
{
    return fmt::format("worst pixel ({}, {}), {:.3g} of what is allowed: drawn {} exact {} allowed {}", x, y, excess,
                       colorText(drawn), colorText(exact), colorText(allowed));
}

} // namespace torrance
