#include "files/json_parse.h"

#include "core/error.h"
#include "files/json_read.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace torrance {
namespace {

// As deep as readJson lets it be.
Json converted(const nlohmann::json& json)
{
    switch (json.type()) {
    case nlohmann::json::value_t::boolean:
        return json.get<bool>();
    case nlohmann::json::value_t::number_integer:
        return json.get<std::int64_t>();
    case nlohmann::json::value_t::number_unsigned:
        if (json.get<std::uint64_t>() <= static_cast<std::uint64_t>(INT64_MAX))
            return json.get<std::int64_t>();
        return json.get<double>();
    case nlohmann::json::value_t::number_float:
        return json.get<double>();
    case nlohmann::json::value_t::string:
        return json.get<std::string>();
    case nlohmann::json::value_t::array: {
        Json::Array array;
        for (const nlohmann::json& element : json)
            array.push_back(converted(element));
        return array;
    }
    case nlohmann::json::value_t::object: {
        Json::Object object;
        for (const auto& [name, member] : json.items())
            object.emplace_back(name, converted(member));
        return object;
    }
    default:
        return {};
    }
}

const Json* find(const Json& json, std::string_view name)
{
    const auto* object = std::get_if<Json::Object>(&json.value);
    if (!object)
        return nullptr;
    const auto found = std::ranges::find(*object, name, [](const auto& m) -> std::string_view { return m.first; });
    return found == object->end() ? nullptr : &found->second;
}

} // namespace

Json parseJson(std::string_view text, const std::string& file)
{
    return converted(readJson(text, file));
}

void JsonView::refuse(std::string_view problem) const
{
    throw inputError(file, path.empty() ? "/" : path, problem, "name a file that the program has written");
}

bool JsonView::has(std::string_view name) const
{
    return find(*value, name) != nullptr;
}

JsonView JsonView::member(std::string_view name) const
{
    const Json* const found = find(*value, name);
    const std::string inner = path + "/" + std::string(name);
    if (!found)
        JsonView(*value, file, inner).refuse("is missing");
    return {*found, file, inner};
}

std::vector<JsonView> JsonView::elements() const
{
    const auto* array = std::get_if<Json::Array>(&value->value);
    if (!array)
        refuse("is no array");
    std::vector<JsonView> views;
    for (std::size_t i = 0; i < array->size(); ++i)
        views.emplace_back((*array)[i], file, path + "/" + std::to_string(i));
    return views;
}

std::string JsonView::text() const
{
    if (const auto* text = std::get_if<std::string>(&value->value))
        return *text;
    refuse("is no text");
}

double JsonView::number() const
{
    if (const auto* whole = std::get_if<std::int64_t>(&value->value))
        return static_cast<double>(*whole);
    if (const auto* number = std::get_if<double>(&value->value))
        return *number;
    refuse("is no number");
}

bool JsonView::boolean() const
{
    if (const auto* flag = std::get_if<bool>(&value->value))
        return *flag;
    refuse("is neither true nor false");
}

double JsonView::numberOr(double otherwise) const
{
    return std::holds_alternative<std::nullptr_t>(value->value) ? otherwise : number();
}

} // namespace torrance
