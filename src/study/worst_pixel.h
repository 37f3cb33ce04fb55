// The worst pixel of a picture against what it should be, with what is needed to look into it.
#pragma once

#include "math/vector.h"

#include <string>

namespace torrance {

struct WorstExcess
{
    double excess = 0.0; // error over what is allowed; at most 1 passes
    int x = 0, y = 0;
    dvec3 drawn = dvec3(0.0), exact = dvec3(0.0), allowed = dvec3(0.0);

    /// Takes the pixel where one of its channels is worse than all before; its greatest excess.
    double note(int px, int py, const dvec3& drawnColor, const dvec3& exactColor, const dvec3& allowedError);
    std::string text() const;
};

} // namespace torrance
