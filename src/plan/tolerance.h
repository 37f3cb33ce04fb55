// How far a picture may be off.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace torrance {

/// Shares of the light, of the part *shading* (DESIGN: the pixel's own surfaces, integrated exactly).
struct Tolerance
{
    double mean = 0.01;                 // sum of |d - c|_1 over that of |c|_1
    std::optional<double> percentile99; // of a pixel's |d - c|_1 / (|c|_1 + 1 % of the mean)
};

struct NamedTolerance
{
    std::string_view name;
    double mean;
};

inline constexpr std::array kNamedTolerances = {NamedTolerance{"draft", 0.05}, NamedTolerance{"standard", 0.01},
                                                NamedTolerance{"exact", 0.001}};

} // namespace torrance
