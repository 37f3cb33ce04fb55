// Student's distribution: how far an estimate may lie from the truth when its own spread is estimated, too.
#pragma once

namespace torrance {

/// P(T <= t) for `degrees` > 0 degrees of freedom, any fraction: by the regularised incomplete beta function
/// (Abramowitz & Stegun 26.7.1 and 26.5.8). Within 1e-12.
double studentCumulative(double t, double degrees);

/// The t that |T| exceeds with probability 0.05: half the width of a 95 % interval in standard errors. Degrees below
/// kLeastDegrees count as kLeastDegrees, infinity is allowed.
double student95(double degrees);

/// One value's worth of knowledge of a spread is the least there is.
inline constexpr double kLeastDegrees = 1.0;

} // namespace torrance
