// Kinds of option values that CLI11 does not know.
#pragma once

#include "math/vector.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace torrance {

/// An option that takes one of `known`; another value is refused with the nearest of them.
CLI::Option* addChoice(CLI::App& app, const std::string& name, std::string& value, std::vector<std::string> known,
                       const std::string& description);

/// "a, b, c".
std::string listed(const std::vector<std::string>& names);

/// The parts between commas; none of an empty text.
std::vector<std::string> splitAtCommas(const std::string& text);

/// Between `least` and `most` finite numbers separated by commas; an Error (usage) names the option.
std::vector<double> parseNumbers(const std::string& option, const std::string& text, std::size_t least,
                                 std::size_t most);

/// A share of a whole: 0.01 or 1%. An Error (usage) names the option; any finite number passes.
double parseShare(const std::string& option, const std::string& text);

/// #RRGGBB in sRGB, as linear light; nothing where the text is none.
std::optional<dvec3> parseHexColor(const std::string& text);

} // namespace torrance
