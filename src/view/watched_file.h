// A file, or a folder with all that lies below it, that is read again when it changes.
#pragma once

#include <algorithm>
#include <filesystem>

namespace torrance {

class WatchedFile
{
public:
    explicit WatchedFile(std::filesystem::path file) : path(std::move(file)), time(timeOf(path)) {}

    /// Whether it, or what lies below it, was written since the last call. A file that is gone has not changed: it is
    /// mostly being replaced.
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
        using Time = std::filesystem::file_time_type;
        std::error_code failure;
        const Time own = std::filesystem::last_write_time(file, failure);
        Time latest = failure ? Time::min() : own;
        const auto options = std::filesystem::directory_options::skip_permission_denied;
        auto entry = std::filesystem::recursive_directory_iterator(file, options, failure); // of a file: none
        for (; !failure && entry != std::filesystem::recursive_directory_iterator(); entry.increment(failure)) {
            std::error_code gone;
            if (const Time time = entry->last_write_time(gone); !gone)
                latest = std::max(latest, time);
        }
        return latest;
    }
    std::filesystem::path path;
    std::filesystem::file_time_type time;
};

} // namespace torrance
