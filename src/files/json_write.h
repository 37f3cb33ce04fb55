// Results as JSON: an ordered value and its text.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace torrance {

/// A JSON value. Members keep the order in which they were given; a number that is not finite becomes null.
struct Json
{
    using Array = std::vector<Json>;
    using Object = std::vector<std::pair<std::string, Json>>;

    std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, Array, Object> value = nullptr;

    Json() = default;
    Json(bool v) : value(v) {}
    Json(int v) : value(static_cast<std::int64_t>(v)) {}
    Json(std::int64_t v) : value(v) {}
    Json(std::size_t v) : value(static_cast<std::int64_t>(v)) {}
    Json(double v) : value(v) {}
    Json(const char* v) : value(std::string(v)) {}
    Json(std::string v) : value(std::move(v)) {}
    Json(Array v) : value(std::move(v)) {}
    Json(Object v) : value(std::move(v)) {}
};

/// Two spaces of indentation, arrays of numbers in one line, shortest digits that read back to the same double, UTF-8,
/// ending in a line break.
std::string jsonText(const Json& json);

/// To a file, whole or not at all, or to standard output where `file` is "-". Nothing where `file` is empty.
void writeJson(const std::string& file, const Json& json);

} // namespace torrance
