#include "app/option_value.h"

#include "core/error.h"
#include "core/nearest_name.h"
#include "image/srgb.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace torrance {

std::string listed(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

int hexDigit(char c)
{
    const std::string_view digits = "0123456789abcdef";
    const std::size_t at = digits.find(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
    return at == std::string_view::npos ? -1 : static_cast<int>(at);
}

namespace {

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

std::vector<std::string> splitAtCommas(const std::string& text)
{
    std::vector<std::string> parts;
    for (std::size_t first = 0; !text.empty() && first <= text.size();) {
        const std::size_t end = std::min(text.find(',', first), text.size());
        parts.push_back(text.substr(first, end - first));
        first = end + 1;
    }
    return parts;
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

double parseShare(const std::string& option, const std::string& text)
{
    const bool percent = text.ends_with('%');
    const char* const end = text.data() + text.size() - (percent ? 1 : 0);
    double number = 0.0;
    const auto [next, failure] = std::from_chars(text.data(), end, number);
    if (failure != std::errc() || next != end || !std::isfinite(number))
        throw usageError(option + " " + text + ": is no share", "write 0.01 or 1%");
    return percent ? number / 100.0 : number;
}

std::optional<dvec3> parseHexColor(const std::string& text)
{
    if (text.size() != 7 || text[0] != '#')
        return std::nullopt;
    dvec3 color(0.0);
    for (std::size_t c = 0; c < 3; ++c) {
        const int high = hexDigit(text[1 + 2 * c]), low = hexDigit(text[2 + 2 * c]);
        if (high < 0 || low < 0)
            return std::nullopt;
        color[static_cast<int>(c)] = srgbDecode((16 * high + low) / 255.0);
    }
    return color;
}

} // namespace torrance
