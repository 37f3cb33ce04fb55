// From what was drawn to what a screen is sent: exposure, tone curve, transfer curve (the exact sRGB unless
// another is asked for), in this order and once.
#pragma once

#include "image/image.h"
#include "image/tone_curves.h"
#include "image/transfer_curves.h"
#include "math/float4.h"

namespace torrance {

enum class AlphaRule
{
    straight,  // colour divided by its coverage before the curve, alpha kept: PNG, WebP
    overBlack, // premultiplied colour as it stands, alpha dropped: JPEG, which has none
};

struct DisplaySettings
{
    double exposure = 0.0; // stops
    const ToneCurve* tone = findToneCurve("khronos_neutral");
    const TransferCurve* transfer = findTransferCurve("srgb");
    AlphaRule alpha = AlphaRule::straight;
};

/// `sceneLinear` has 3 channels, or 4 with premultiplied alpha. The result is encoded, in [0, 1] but for the curve
/// `none`: 3 channels, or 4 with straight alpha. Coverage 0 gives colour 0. No value of the input gives a NaN.
Image toDisplay(const Image& sceneLinear, const DisplaySettings& settings);

// The parts of toDisplay, for those who want codes and no picture.

/// One row of it: width times 3 or 4 numbers.
void displayRow(const Image& sceneLinear, int y, const DisplaySettings& settings, float* encoded);
/// Whether there are 4.
bool keepsCoverage(const Image& sceneLinear, const DisplaySettings& settings);
float exposureGain(const DisplaySettings& settings);
/// What colours under an alpha are multiplied with, or under each of four. Additive light (glare over nothing) has
/// coverage 0 and colour: it cannot be told in straight alpha, and is dropped with it.
template <typename T>
T coverageScale(T alpha)
{
    const T nothing = T{}, one = nothing + 1.0f;
    return alpha > nothing ? one / least(alpha, one) : nothing;
}

} // namespace torrance
