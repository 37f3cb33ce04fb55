#include "view/recovery.h"

#include "core/error.h"
#include "core/user_folder.h"

namespace torrance {

std::filesystem::path userStateFolder()
{
    return userFolder("XDG_STATE_HOME", ".local/state");
}

std::filesystem::path recoveryFile(const std::filesystem::path& stateFolder, const std::string& input)
{
    if (stateFolder.empty())
        throw writeError("a file for them", "there is no folder of the user's", "set XDG_STATE_HOME or HOME");
    std::error_code failure;
    std::filesystem::create_directories(stateFolder, failure);
    if (failure)
        throw writeError(stateFolder.string(), failure.message(),
                         "name a folder that can be written with XDG_STATE_HOME");
    const std::string stem = std::filesystem::path(input).stem().string() + "-unsaved";
    std::filesystem::path file = stateFolder / (stem + ".glb");
    for (int i = 2; std::filesystem::exists(file, failure); ++i)
        file = stateFolder / (stem + "-" + std::to_string(i) + ".glb");
    return file;
}

} // namespace torrance
