// Whole powers by multiplication: std::pow takes five times as long as all else of Schlick's term.
#pragma once

namespace torrance {

/// x^5, to 3 roundings.
inline double fifthPower(double x)
{
    const double square = x * x;
    return square * square * x;
}

} // namespace torrance
