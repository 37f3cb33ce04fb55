#include "files/json_write.h"

#include "core/atomic_write.h"
#include "core/standard_output.h"

#include <nlohmann/json.hpp>

namespace torrance {
namespace {

using Ordered = nlohmann::ordered_json;

Ordered converted(const Json& json);

struct Converter
{
    Ordered operator()(const Json::Array& array) const
    {
        Ordered result = Ordered::array();
        for (const Json& element : array)
            result.push_back(converted(element));
        return result;
    }
    Ordered operator()(const Json::Object& object) const
    {
        Ordered result = Ordered::object();
        for (const auto& [name, member] : object)
            result[name] = converted(member);
        return result;
    }
    template <typename T>
    Ordered operator()(const T& scalar) const
    {
        return scalar;
    }
};

Ordered converted(const Json& json)
{
    return std::visit(Converter{}, json.value);
}

} // namespace

std::string jsonText(const Json& json)
{
    // Names from files may hold bytes that are not UTF-8: they are replaced, not refused.
    return converted(json).dump(2, ' ', false, Ordered::error_handler_t::replace) + "\n";
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
