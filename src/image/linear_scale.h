// A picture of numbers that are no light, made one that can be shown.
#pragma once

#include "image/image.h"

namespace torrance {

/// The greatest finite value of the first three channels; 0 where there is none above it.
double greatestValue(const Image& image);

/// factor x + offset in the first three channels of a premultiplied picture, the offset by coverage.
Image scaled(const Image& premultiplied, double factor, double offset);

} // namespace torrance
