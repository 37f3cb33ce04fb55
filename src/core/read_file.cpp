#include "core/read_file.h"

#include "core/error.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace torrance {
namespace {

struct Descriptor
{
    explicit Descriptor(const std::filesystem::path& path)
        : number(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK))
    {
    }
    ~Descriptor()
    {
        if (number >= 0)
            close(number);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number;
};

std::uint64_t checkedSize(const Descriptor& file, const std::string& name)
{
    struct stat status = {};
    if (file.number < 0 || fstat(file.number, &status) != 0)
        throw inputError(name, "", std::strerror(errno), "check the path");
    if (S_ISDIR(status.st_mode))
        throw inputError(name, "", "is a directory", "name a file in it");
    if (!S_ISREG(status.st_mode))
        throw inputError(name, "", "is not a regular file", "name a file");
    if (status.st_size == 0)
        throw inputError(name, "", "is empty", "get the file again");
    if (static_cast<std::uint64_t>(status.st_size) > kMaxFileBytes)
        throw inputError(name, "", "is larger than 4 GiB", "split or shrink it");
    return static_cast<std::uint64_t>(status.st_size);
}

} // namespace

std::vector<std::byte> readFile(const std::filesystem::path& path)
{
    const Descriptor file(path); // O_NONBLOCK: opening a pipe that nobody writes to must not hang
    std::vector<std::byte> bytes(checkedSize(file, path.string()));
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t n = read(file.number, bytes.data() + done, bytes.size() - done);
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            throw inputError(path.string(), "", std::strerror(errno), "check the disk");
        if (n == 0)
            throw inputError(path.string(), "", "became shorter while it was read",
                             "read it again when it is complete");
        done += static_cast<std::size_t>(n);
    }
    return bytes;
}

} // namespace torrance
