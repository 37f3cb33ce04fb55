// How far the work is, and how long it will take: a bar on a terminal, some lines with --verbose elsewhere, nothing
// otherwise.
#pragma once

#include <chrono>
#include <string>

namespace torrance {

/// Standard error is a terminal, and quiet was not asked for: people are watching.
bool peopleAreWatching();

class ProgressLine
{
public:
    explicit ProgressLine(std::string label);
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(int done, int all);
    void clear();

private:
    std::string label;
    bool terminal;
    bool shown = false;
    int before = -1; // what was done when this began: an interrupted run goes on
    std::chrono::steady_clock::time_point start;
};

} // namespace torrance
