#include "app/output_folder.h"

#include "core/error.h"

namespace torrance {

std::filesystem::path madeFolder(const std::string& name)
{
    std::error_code failure;
    std::filesystem::create_directories(name, failure);
    if (!std::filesystem::is_directory(name))
        throw writeError(name, failure ? failure.message() : "is not a folder", "choose another folder");
    return name;
}

} // namespace torrance
