// Which of several things are worth their price: those that nothing cheaper is as good as.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace torrance {

/// Both are to be small.
struct CostAndError
{
    double cost = 0.0;
    double error = 0.0;
};

/// Indices of the points that no other one dominates, by ascending cost. A point dominates another where it is as cheap
/// and as exact and one of both is better; of points alike in both, all stay. Points with a NaN are on no front.
std::vector<std::size_t> paretoFront(std::span<const CostAndError> points);

} // namespace torrance
