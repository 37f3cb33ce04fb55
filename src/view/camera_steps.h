// How far a press of a key, or a step of a wheel, moves the camera.
#pragma once

#include "view/orbit_pose.h"

namespace torrance {

inline constexpr double kTurnStep = 5.0;    // degrees
inline constexpr double kFlyStep = 0.05;    // parts of the distance to the target
inline constexpr double kDollyStep = 1.1;   // times the distance
inline constexpr double kAcrossStep = 0.05; // parts of the picture's height

/// What a wheel does, or two fingers on a trackpad. `steps` are those of a wheel, and fractions of them: y away from
/// the hand, x to the left. Nearer and farther, or about the target, whichever is more: fingers that go up go a little
/// aside, too. With `across` (Shift) the camera moves across, both ways at once. `diagonal` is that of the scene's
/// bounds.
void scroll(OrbitPose& pose, const dvec2& steps, bool across, double diagonal);

} // namespace torrance
