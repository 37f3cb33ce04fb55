#include "app/option_value.h"

#include "core/error.h"
#include "core/nearest_name.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace torrance {
namespace {

std::string listed(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// Empty where `value` is known: what CLI11 expects of a validator.
std::string problemWith(const std::string& value, const std::vector<std::string>& known)
{
    if (std::find(known.begin(), known.end(), value) != known.end())
        return {};
    const std::string nearest = nearestName(value, known);
    return "unknown value " + value +
           (nearest.empty() ? ", known are " + listed(known) : ", did you mean " + nearest + "?");
}

} // namespace

CLI::Option* addChoice(CLI::App& app, const std::string& name, std::string& value, std::vector<std::string> known,
                       const std::string& description)
{
    CLI::Option* option = app.add_option(name, value, description + " (" + listed(known) + ")");
    option->type_name("NAME");
    return option->check([known = std::move(known)](const std::string& given) { return problemWith(given, known); });
}

std::vector<double> parseNumbers(const std::string& option, const std::string& text, std::size_t least,
                                 std::size_t most)
{
    std::vector<double> numbers;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at != end) {
        if (*at == '+')
            ++at;
        double number = 0.0;
        const auto [next, failure] = std::from_chars(at, end, number);
        if (failure != std::errc() || !std::isfinite(number) || (next != end && *next != ','))
            throw usageError(option + " " + text + ": not a list of numbers", "separate them by commas");
        numbers.push_back(number);
        at = next == end ? end : next + 1;
    }
    if (numbers.size() < least || numbers.size() > most || text.ends_with(','))
        throw usageError(option + " " + text + ": " + std::to_string(numbers.size()) + " numbers",
                         "it takes " + std::to_string(least) + (least == most ? "" : " to " + std::to_string(most)));
    return numbers;
}

} // namespace torrance
