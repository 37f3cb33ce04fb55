#include "core/user_folder.h"

#include <cstdlib>

namespace torrance {

std::filesystem::path userFolder(const char* variable, const std::filesystem::path& underHome)
{
    if (const char* folder = std::getenv(variable); folder && *folder)
        return std::filesystem::path(folder) / "torrance";
    if (const char* home = std::getenv("HOME"); home && *home)
        return std::filesystem::path(home) / underHome / "torrance";
    return {};
}

} // namespace torrance
