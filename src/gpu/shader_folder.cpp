#include "gpu/shader_folder.h"

#include "core/data_folder.h"
#include "core/error.h"

#include <fstream>
#include <iterator>
#include <string>

namespace torrance::gpu {

std::filesystem::path shaderFolder()
{
    std::filesystem::path folder = dataFolder() / "shaders";
    for (const SharedHeader& header : sharedHeaders()) {
        const std::filesystem::path path = folder / "shared" / header.name;
        std::ifstream file(path, std::ios::binary);
        if (std::string(std::istreambuf_iterator<char>(file), {}) != header.text)
            throw usageError(path.string() + ": is not what this program was built with",
                             "build it again, or set TORRANCE_DATA to the share/torrance folder that it came with");
    }
    return folder;
}

} // namespace torrance::gpu
