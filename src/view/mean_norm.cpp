#include "view/mean_norm.h"

#include <algorithm>
#include <cmath>

namespace torrance {

double coveredMeanNorm(const PixelEstimator& estimator, const Image& drawn)
{
    const int columns = std::min(kNormGrid, drawn.width), rows = std::min(kNormGrid, drawn.height);
    double sum = 0.0;
    int count = 0;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int x = (2 * column + 1) * drawn.width / (2 * columns), y = (2 * row + 1) * drawn.height / (2 * rows);
            if (!estimator.seenFrom(x, y))
                continue;
            const float* texel = drawn.at(x, y);
            sum += std::abs(double(texel[0])) + std::abs(double(texel[1])) + std::abs(double(texel[2]));
            ++count;
        }
    return count > 0 ? sum / count : 0.0;
}

} // namespace torrance
