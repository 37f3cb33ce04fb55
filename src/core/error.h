// What can go wrong, said in one line that names file, item and remedy, with the exit code that the process ends with.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace torrance {

enum class ExitCode : int
{
    success = 0,
    checkFailed = 1,   // a comparison or check did not hold
    usage = 2,         // the command line
    input = 3,         // a file that was read
    noDevice = 4,      // no usable Vulkan device
    deviceFailure = 5, // the device failed while working
    cannotWrite = 6,   // a file that was to be written
};

class Error : public std::runtime_error
{
public:
    Error(ExitCode code, const std::string& message) : std::runtime_error(message), exitCode(code) {}

    ExitCode exitCode;
};

/// `text` with every control character replaced by `?`: names come from files, and what is printed stays one line and
/// moves no cursor.
std::string oneLine(std::string text);

/// `file: item: problem; remedy`. Item and remedy may be empty. Control characters in names taken from a file are
/// replaced, so that the message stays one line.
Error inputError(std::string_view file, std::string_view item, std::string_view problem, std::string_view remedy);
Error usageError(std::string_view problem, std::string_view remedy);
Error writeError(std::string_view file, std::string_view problem, std::string_view remedy);

} // namespace torrance
