#include "app/option_value.h"

#include "core/nearest_name.h"

#include <CLI/CLI.hpp>

#include <algorithm>

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

} // namespace torrance
