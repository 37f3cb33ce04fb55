#include "core/log.h"

#include <atomic>
#include <cstdio>
#include <string>

namespace torrance {
namespace {

std::atomic<LogLevel> currentLevel = LogLevel::normal;

// One write per line: lines of several threads or processes do not mix.
void writeLine(std::string_view prefix, std::string_view line)
{
    std::string text(prefix);
    text.append(line).push_back('\n');
    std::fwrite(text.data(), 1, text.size(), stderr);
}

} // namespace

void setLogLevel(LogLevel level)
{
    currentLevel = level;
}

LogLevel logLevel()
{
    return currentLevel;
}

void logError(std::string_view line)
{
    writeLine("torrance: error: ", line);
}

void logWarning(std::string_view line)
{
    if (currentLevel != LogLevel::quiet)
        writeLine("torrance: warning: ", line);
}

void logInfo(std::string_view line)
{
    if (currentLevel == LogLevel::verbose)
        writeLine("torrance: ", line);
}

} // namespace torrance
