// Lines for people, on standard error. Standard output belongs to results.
#pragma once

#include <string_view>

namespace torrance {

enum class LogLevel
{
    quiet,   // errors only
    normal,  // and warnings
    verbose, // and what is being done
};

void setLogLevel(LogLevel level);
LogLevel logLevel();

void logError(std::string_view line);
void logWarning(std::string_view line);
void logInfo(std::string_view line); // shown when verbose

} // namespace torrance
