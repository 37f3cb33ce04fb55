#include "measure/statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace torrance {
namespace {

// Below this many values a plain sum is as good.
constexpr std::size_t kPlainSum = 64;

double pairwiseSum(std::span<const float> values)
{
    if (values.size() > kPlainSum) {
        const std::size_t half = values.size() / 2;
        return pairwiseSum(values.first(half)) + pairwiseSum(values.subspan(half));
    }
    double sum = 0.0;
    for (const float value : values)
        sum += value;
    return sum;
}

} // namespace

double mean(std::span<const float> values)
{
    return values.empty() ? 0.0 : pairwiseSum(values) / static_cast<double>(values.size());
}

double percentile(std::span<const float> values, double rank)
{
    if (values.empty())
        return 0.0;
    std::vector<float> sorted(values.begin(), values.end());
    const auto count = static_cast<double>(sorted.size());
    const auto place = static_cast<std::ptrdiff_t>(std::clamp(std::ceil(rank * count), 1.0, count)) - 1;
    std::nth_element(sorted.begin(), sorted.begin() + place, sorted.end());
    return sorted[static_cast<std::size_t>(place)];
}

} // namespace torrance
