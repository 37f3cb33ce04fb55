#include "core/data_folder.h"

#include "core/error.h"

#include <cstdlib>

namespace torrance {

std::filesystem::path dataFolder()
{
    namespace fs = std::filesystem;
    std::error_code failure;
    fs::path folder;
    if (const char* asked = std::getenv("TORRANCE_DATA"))
        folder = asked;
    else
        folder = fs::read_symlink("/proc/self/exe", failure).parent_path().parent_path() / "share" / "torrance";
    if (!fs::is_directory(folder, failure))
        throw usageError(folder.string() + ": the program's data are not there",
                         "install Torrance whole, or set TORRANCE_DATA to its share/torrance folder");
    return folder;
}

} // namespace torrance
