// Transfer curves: display-linear colour to the codes of a file. Rows of the method registry, slot `transfer`.
#pragma once

#include "math/vector.h"

#include <span>
#include <string_view>

namespace torrance {

/// x^(1/2.2) per channel, the shortcut that stands in for sRGB: it lacks the straight piece at black and is off by up
/// to 0.03 of the codes' range in the dark. NaN and negative give 0; above 1 the power goes on.
dvec3 transfer_gamma22(const dvec3& linear);

/// The identity, for pictures that hold data or are encoded elsewhere. NaN and negative give 0.
dvec3 transfer_linear(const dvec3& linear);

/// A curve by the id of its registry row, of one channel in float and of a colour in double.
struct TransferCurve
{
    std::string_view id;
    dvec3 (*exact)(const dvec3&);
    float (*single)(float);
};

/// The exact sRGB curve (image/srgb.h) first.
std::span<const TransferCurve> allTransferCurves();
/// Null where the id is not known.
const TransferCurve* findTransferCurve(std::string_view id);

} // namespace torrance
