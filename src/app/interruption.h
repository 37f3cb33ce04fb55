// Ctrl-C and a polite end (SIGINT, SIGTERM) for work that wants to keep what it has.
#pragma once

namespace torrance {

/// While one lives, the signals are noted instead of ending the process. One at a time.
class Interruption
{
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    bool came() const;
    /// Ends the process by the signal that came, as if it had not been noted: whoever started it sees that.
    [[noreturn]] void obey() const;
};

} // namespace torrance
