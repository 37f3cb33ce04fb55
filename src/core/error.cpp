#include "core/error.h"

#include <utility>

namespace torrance {
namespace {

std::string joined(std::string_view file, std::string_view item, std::string_view problem, std::string_view remedy)
{
    std::string text;
    for (std::string_view part : {file, item})
        if (!part.empty())
            text.append(part).append(": ");
    text.append(problem);
    if (!remedy.empty())
        text.append("; ").append(remedy);
    return oneLine(std::move(text));
}

} // namespace

std::string oneLine(std::string text)
{
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            c = '?';
    return text;
}

Error inputError(std::string_view file, std::string_view item, std::string_view problem, std::string_view remedy)
{
    return {ExitCode::input, joined(file, item, problem, remedy)};
}

Error usageError(std::string_view problem, std::string_view remedy)
{
    return {ExitCode::usage, joined("", "", problem, remedy)};
}

Error writeError(std::string_view file, std::string_view problem, std::string_view remedy)
{
    return {ExitCode::cannotWrite, joined(file, "", problem, remedy)};
}

} // namespace torrance
