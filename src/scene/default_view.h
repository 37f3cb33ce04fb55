// The camera where nothing is asked for: the view that shows a thing best when nothing is known of it, from the right,
// a little from above.
#pragma once

namespace torrance {

inline constexpr double kDefaultTheta = 30.0, kDefaultPhi = 75.0; // degrees, as of OrbitAngles
inline constexpr double kDefaultFov = 45.0;                       // degrees, vertical
inline constexpr double kDefaultMargin = 0.05;                    // of the picture, on each side

} // namespace torrance
