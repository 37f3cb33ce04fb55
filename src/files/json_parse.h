// JSON that this program wrote, read again.
#pragma once

#include "files/json_write.h"

#include <string>
#include <string_view>

namespace torrance {

/// The text as a value; whole numbers beyond 64 bits with sign become doubles. Errors (input) as of json_read.h.
Json parseJson(std::string_view text, const std::string& file);

/// A value and where it stands ("/items/0/name"): Errors (input) name the file and the place of what is missing or of
/// another kind. The value must outlive it.
class JsonView
{
public:
    JsonView(const Json& json, std::string fileName, std::string pathInFile = "")
        : value(&json), file(std::move(fileName)), path(std::move(pathInFile))
    {
    }

    JsonView member(std::string_view name) const;
    bool has(std::string_view name) const;
    std::vector<JsonView> elements() const;

    std::string text() const;
    double number() const;
    bool boolean() const;
    /// `otherwise` for null: what a number that is not finite was written as.
    double numberOr(double otherwise) const;

    /// The Error that names this place.
    [[noreturn]] void refuse(std::string_view problem) const;

private:
    const Json* value;
    std::string file;
    std::string path;
};

} // namespace torrance
