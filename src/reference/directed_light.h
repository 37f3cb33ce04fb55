// Light that arrives from one direction, and how likely it was to be asked for.
#pragma once

#include "math/vector.h"

namespace torrance {

struct DirectedLight
{
    dvec3 radiance = dvec3(0.0);
    double density = 0.0; // of drawing this direction from the light, 1/sr
};

} // namespace torrance
