#include "files/read_file.h"

#include "core/error.h"

#include <algorithm>
#include <fstream>

namespace torrance {
namespace fs = std::filesystem;

std::vector<std::byte> readFile(const fs::path& path, const std::string& file, const std::string& item,
                                std::uint64_t most)
{
    std::error_code failure;
    const fs::file_status status = fs::status(path, failure);
    if (status.type() == fs::file_type::not_found)
        throw inputError(file, item, "no such file", "check the name and the folder");
    if (fs::is_directory(status))
        throw inputError(file, item, "is a folder", "name a file in it");
    if (!fs::is_regular_file(status))
        throw inputError(file, item, "is not a regular file", "copy its content to a file first");

    const std::uint64_t size = fs::file_size(path, failure);
    if (failure)
        throw inputError(file, item, failure.message(), "check the permissions");
    if (size > kMaxFileBytes && most == kMaxFileBytes)
        throw inputError(file, item, "is larger than 4 GiB", "split the model");

    std::ifstream stream(path, std::ios::binary);
    std::vector<std::byte> bytes(std::min(size, most));
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!stream)
        throw inputError(file, item, "cannot be read", "check the permissions");
    return bytes;
}

} // namespace torrance
