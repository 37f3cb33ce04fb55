// One line on a terminal that says how far the work is. Silent where standard error is none, or asked to be quiet.
#pragma once

#include <chrono>
#include <string>

namespace torrance {

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
    bool enabled;
    bool shown = false;
    std::chrono::steady_clock::time_point start;
};

} // namespace torrance
