// Work that is not wanted any more ends by an exception, wherever it looks whether it is.
#pragma once

#include <stop_token>

namespace torrance {

/// No error: nobody waits for the result.
struct Cancelled
{
};

/// Throws Cancelled where a stop was asked for.
inline void endWhereStopped(const std::stop_token& stop)
{
    if (stop.stop_requested())
        throw Cancelled();
}

} // namespace torrance
