// Directions in proportion to the light that comes from them.
#pragma once

#include "image/image.h"
#include "math/vector.h"

#include <vector>

namespace torrance::assets {

class LightDirections
{
public:
    explicit LightDirections(const Image& panorama);

    /// s in [0, 1) picks the texel, (a, b) the place inside it.
    dvec3 at(double s, double a, double b) const;

private:
    int width;
    int height;
    std::vector<double> cumulative; // per texel, ends with 1
};

} // namespace torrance::assets
