#include "app/progress_line.h"

#include "core/log.h"

#include <cstdio>
#include <unistd.h>

namespace torrance {

ProgressLine::ProgressLine(std::string text)
    : label(std::move(text)), enabled(isatty(STDERR_FILENO) && logLevel() != LogLevel::quiet),
      start(std::chrono::steady_clock::now())
{
}

void ProgressLine::show(int done, int all)
{
    if (!enabled)
        return;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double left = done > 0 ? seconds * (all - done) / done : 0.0;
    std::fprintf(stderr, "\r%s: %d of %d, %.1f s left\033[K", label.c_str(), done, all, left);
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
