#include "app/progress_line.h"

#include "core/log.h"

#include <cstdint>
#include <cstdio>
#include <unistd.h>

namespace torrance {
namespace {

constexpr int kLogLines = 20; // of --verbose elsewhere than on a terminal
constexpr std::size_t kBarWidth = 24;

} // namespace

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
    if (before < 0)
        before = done - 1;
    if (!terminal) {
        if (all <= kLogLines || kLogLines * done / all != kLogLines * (done - 1) / all)
            logInfo(label + ": " + std::to_string(done) + " of " + std::to_string(all));
        return;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double left = seconds * (all - done) / (done - before);
    const auto filled = static_cast<std::size_t>(static_cast<std::int64_t>(kBarWidth) * done / all);
    const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, '.');
    std::fprintf(stderr, "\r%s [%s] %d of %d, %.1f s left\033[K", label.c_str(), bar.c_str(), done, all, left);
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
