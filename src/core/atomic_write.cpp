#include "core/atomic_write.h"

#include "core/error.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <unistd.h>

namespace torrance {
namespace {

namespace fs = std::filesystem;

fs::path temporaryName(const fs::path& path)
{
    static std::atomic<unsigned> counter = 0;
    const std::string name = "." + path.stem().string() + "." + std::to_string(getpid()) + "-" +
                             std::to_string(counter++) + path.extension().string();
    return path.parent_path() / name;
}

class TemporaryFile
{
public:
    /// Makes and opens it. A process of our number that was ended may have left one.
    explicit TemporaryFile(const fs::path& target)
    {
        constexpr int kTries = 1000;
        for (int i = 0; i < kTries && descriptor < 0 && (i == 0 || errno == EEXIST); ++i) {
            name = temporaryName(target);
            descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        }
        kept = descriptor < 0; // nothing to remove
    }
    ~TemporaryFile()
    {
        std::error_code ignored;
        if (!kept)
            fs::remove(name, ignored);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    void renameTo(const fs::path& target)
    {
        std::error_code failure;
        fs::rename(name, target, failure);
        if (failure)
            throw writeError(target.string(), failure.message(), "choose another output");
        kept = true;
    }

    fs::path name;
    int descriptor = -1; // the caller closes it

private:
    bool kept = false;
};

[[noreturn]] void failWithErrno(const fs::path& path)
{
    throw writeError(path.string(), std::strerror(errno), "choose a writable place with free space");
}

void checkTarget(const fs::path& path)
{
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
        throw writeError(path.string(), "is a directory", "name a file");
}

// A device or pipe (/dev/null, /dev/stdout) is written to: renaming a file onto it would put an end to it.
bool isDevice(const fs::path& path)
{
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status);
}

bool writeAll(int file, std::span<const std::byte> bytes)
{
    while (!bytes.empty()) {
        const ssize_t n = write(file, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(n));
    }
    return true;
}

void writeAndClose(int file, const fs::path& path, std::span<const std::span<const std::byte>> parts)
{
    if (file < 0)
        failWithErrno(path);
    for (const auto part : parts)
        if (!writeAll(file, part)) {
            const int failure = errno;
            close(file);
            errno = failure;
            failWithErrno(path);
        }
    if (close(file) != 0)
        failWithErrno(path);
}

} // namespace

void writeFile(const fs::path& path, std::span<const std::byte> bytes)
{
    writeFile(path, std::span(&bytes, 1));
}

void writeFile(const fs::path& path, std::span<const std::span<const std::byte>> parts)
{
    checkTarget(path);
    if (isDevice(path)) {
        writeAndClose(open(path.c_str(), O_WRONLY | O_CLOEXEC), path, parts);
        return;
    }
    TemporaryFile temporary(path);
    writeAndClose(temporary.descriptor, path, parts);
    temporary.renameTo(path);
}

void writeFile(const fs::path& path, std::span<const std::byte> bytes,
               const std::function<void(const fs::path&)>& check)
{
    checkTarget(path);
    if (isDevice(path))
        throw writeError(path.string(), "is a device or a pipe", "name a file");
    TemporaryFile temporary(path);
    writeAndClose(temporary.descriptor, path, std::span(&bytes, 1));
    check(temporary.name);
    temporary.renameTo(path);
}

void writeFile(const fs::path& path, std::string_view text)
{
    writeFile(path, std::as_bytes(std::span(text)));
}

} // namespace torrance
