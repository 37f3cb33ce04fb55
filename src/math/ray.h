// A half line in double.
#pragma once

#include "math/vector.h"

namespace torrance {

struct Ray
{
    dvec3 origin = dvec3(0.0);
    dvec3 direction = dvec3(0.0, 0.0, -1.0); // unit
};

} // namespace torrance
