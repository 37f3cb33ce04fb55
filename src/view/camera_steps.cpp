#include "view/camera_steps.h"

#include <cmath>

namespace torrance {

void scroll(OrbitPose& pose, const dvec2& steps, bool across, double diagonal)
{
    if (across)
        pan(pose, -kAcrossStep * steps.x, kAcrossStep * steps.y);
    else if (std::abs(steps.y) >= std::abs(steps.x))
        dolly(pose, std::pow(kDollyStep, -steps.y), diagonal);
    else
        orbit(pose, -kTurnStep * steps.x, 0.0);
}

} // namespace torrance
