#include "files/json_write.h"

#include "core/atomic_write.h"
#include "core/standard_output.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace torrance {
namespace {

using Scalar = nlohmann::json;

constexpr std::size_t kIndent = 2;

// Names from files may hold bytes that are not UTF-8: they are replaced, not refused.
std::string scalarText(const Scalar& scalar)
{
    return scalar.dump(-1, ' ', false, Scalar::error_handler_t::replace);
}

bool isNumber(const Json& json)
{
    return std::holds_alternative<std::int64_t>(json.value) || std::holds_alternative<double>(json.value) ||
           std::holds_alternative<std::nullptr_t>(json.value);
}

void append(std::string& text, const Json& json, std::size_t depth);

// Elements between brackets, one a line or all in one.
template <typename Elements, typename Element>
void appendAll(std::string& text, const char* brackets, const Elements& elements, std::size_t depth, bool inOneLine,
               Element&& element)
{
    const std::string separator = inOneLine ? " " : "\n" + std::string(kIndent * (depth + 1), ' ');
    text += brackets[0];
    for (std::size_t i = 0; i < elements.size(); ++i) {
        text += i > 0 ? "," : "";
        text += i > 0 || !inOneLine ? separator : "";
        element(elements[i]);
    }
    if (!inOneLine && !elements.empty())
        text += "\n" + std::string(kIndent * depth, ' ');
    text += brackets[1];
}

struct Appender
{
    std::string& text;
    std::size_t depth;

    void operator()(const Json::Array& array) const
    {
        appendAll(text, "[]", array, depth, std::ranges::all_of(array, isNumber),
                  [&](const Json& element) { append(text, element, depth + 1); });
    }
    void operator()(const Json::Object& object) const
    {
        appendAll(text, "{}", object, depth, false, [&](const auto& member) {
            text += scalarText(member.first) + ": ";
            append(text, member.second, depth + 1);
        });
    }
    template <typename T>
    void operator()(const T& scalar) const
    {
        text += scalarText(scalar);
    }
};

void append(std::string& text, const Json& json, std::size_t depth)
{
    std::visit(Appender{text, depth}, json.value);
}

} // namespace

std::string jsonText(const Json& json)
{
    std::string text;
    append(text, json, 0);
    return text + "\n";
}

void writeJson(const std::string& file, const Json& json)
{
    if (file.empty())
        return;
    if (file == "-")
        writeStandardOutput(jsonText(json));
    else
        writeFile(file, jsonText(json));
}

} // namespace torrance
