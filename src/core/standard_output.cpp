#include "core/standard_output.h"

#include "core/error.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace torrance {

void writeStandardOutput(std::span<const std::byte> bytes)
{
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size();
    if (!written || std::fflush(stdout) != 0)
        throw writeError("standard output", std::strerror(errno), "send it to a place with free space");
}

void writeStandardOutput(std::string_view text)
{
    writeStandardOutput(std::as_bytes(std::span(text)));
}

} // namespace torrance
