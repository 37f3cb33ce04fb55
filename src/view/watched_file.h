// A file that is read again when it changes.
#pragma once

#include <filesystem>

namespace torrance {

class WatchedFile
{
public:
    explicit WatchedFile(std::filesystem::path file) : path(std::move(file)), time(timeOf(path)) {}

    /// Whether it was written since the last call. A file that is gone has not changed: it is mostly being replaced.
    bool takeChange()
    {
        const auto now = timeOf(path);
        if (now == time || now == std::filesystem::file_time_type::min())
            return false;
        time = now;
        return true;
    }

private:
    static std::filesystem::file_time_type timeOf(const std::filesystem::path& file)
    {
        std::error_code failure;
        const auto result = std::filesystem::last_write_time(file, failure);
        return failure ? std::filesystem::file_time_type::min() : result;
    }
    std::filesystem::path path;
    std::filesystem::file_time_type time;
};

} // namespace torrance
