// The exact sRGB transfer curve, IEC 61966-2-1:1999, both ways.
#pragma once

#include "math/vector.h"

namespace torrance {

/// Display-linear to encoded. NaN and negative give 0; values above 1 continue the power segment.
double srgbEncode(double linear);
float srgbEncode(float linear);

/// Encoded to display-linear; the inverse of srgbEncode.
double srgbDecode(double encoded);
float srgbDecode(float encoded);

/// srgbEncode per channel: the registry's row `srgb` of slot `transfer`.
dvec3 transfer_srgb(const dvec3& linear);

} // namespace torrance
