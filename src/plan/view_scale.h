// How the numbers of a term are shown.
#pragma once

#include "image/image.h"
#include "plan/view.h"

namespace torrance {

/// The term's own scale, or where it has none, the one that makes the greatest value of the picture 1.
ViewScale scaleOf(const View& view, const Image& drawn);

} // namespace torrance
