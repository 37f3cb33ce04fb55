// "Did you mean": the known name closest to an unknown one.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace torrance {

/// Optimal string alignment distance (insertion, deletion, substitution, swap of neighbours), ASCII case ignored.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The nearest of `known`, or empty where none is near (more than a third of the longer name differs).
std::string nearestName(std::string_view unknown, std::span<const std::string> known);

} // namespace torrance
