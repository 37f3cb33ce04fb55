#include "measure/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torrance {

std::vector<std::size_t> paretoFront(std::span<const CostAndError> points)
{
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!std::isnan(points[i].cost) && !std::isnan(points[i].error))
            order.push_back(i);
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return points[a].cost != points[b].cost ? points[a].cost < points[b].cost : points[a].error < points[b].error;
    });
    // From cheap to dear: what is no better than the best so far is dominated, unless it is that one's equal.
    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        const bool first = front.empty();
        const bool better = first || points[i].error < points[front.back()].error;
        const bool alike =
            !first && points[i].error == points[front.back()].error && points[i].cost == points[front.back()].cost;
        if (better || alike)
            front.push_back(i);
    }
    return front;
}

} // namespace torrance
