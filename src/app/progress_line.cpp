#include "app/progress_line.h"

#include "core/log.h"

#include <cstdio>
#include <unistd.h>

namespace torrance {

bool peopleAreWatching()
{
    return isatty(STDERR_FILENO) && logLevel() != LogLevel::quiet;
}

ProgressLine::ProgressLine(std::string text)
    : label(std::move(text)), terminal(peopleAreWatching()), start(std::chrono::steady_clock::now())
{
}

void ProgressLine::show(int done, int all)
{
    const std::string step = label + ": " + std::to_string(done) + " of " + std::to_string(all);
    if (!terminal)
        return logInfo(step);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double left = done > 0 ? seconds * (all - done) / done : 0.0;
    std::fprintf(stderr, "\r%s, %.1f s left\033[K", step.c_str(), left);
    std::fflush(stderr);
    shown = true;
}

void ProgressLine::clear()
{
    if (shown)
        std::fputs("\r\033[K", stderr);
    shown = false;
}

} // namespace torrance
