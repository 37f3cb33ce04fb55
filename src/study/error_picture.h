// Relative errors of a picture's pixels as colours.
#pragma once

#include "image/image.h"

namespace torrance {

/// log10 of an error, from 1e-6 and less (black) to 1 and more (pale yellow), a decade per sixth of the map. One
/// channel in, display-encoded colour out.
Image errorPicture(const Image& errors);

} // namespace torrance
