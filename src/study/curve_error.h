// How far a tone or transfer curve in float lies from the curve that it stands for, in double, on the colours of a
// picture.
#pragma once

#include "image/display.h"
#include "plan/method_table.h"

namespace torrance {

struct CurveJudgement
{
    MethodError error; // without cells
    Image pixels;      // one channel, as of SphereJudgement
};

/// Colours are shown by the method, of the slot tone or transfer, and otherwise as by default.
DisplaySettings displayOf(const brdf::Method& method);

/// What is compared is the light of a screen: of encoded values what a screen makes of them by sRGB. `sceneLinear` has
/// three channels or four.
CurveJudgement judgeCurve(const Image& sceneLinear, const brdf::Method& method, const brdf::Method& truth);

} // namespace torrance
