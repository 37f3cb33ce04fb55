#include "files/sibling_path.h"

#include "core/error.h"

#include <algorithm>

namespace torrance {

std::filesystem::path siblingPath(std::string_view name, const std::filesystem::path& folder, bool allowExternal,
                                  const std::string& file, const std::string& item)
{
    std::string path(name);
    std::replace(path.begin(), path.end(), '\\', '/');
    const std::filesystem::path relative(path);
    const bool hasDrive = path.size() > 1 && path[1] == ':';
    const bool leaves =
        relative.is_absolute() || hasDrive || std::find(relative.begin(), relative.end(), "..") != relative.end();
    if (path.find('\0') != std::string::npos)
        throw inputError(file, item, "names a file with a zero in its name", "export the file again");
    if (leaves && !allowExternal)
        throw inputError(file, item, "refers to \"" + std::string(name.substr(0, 80)) + "\", outside its folder",
                         "put the file beside it and name it without a folder, or give --allow-external");
    return folder / relative;
}

} // namespace torrance
