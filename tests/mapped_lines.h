// What this process has mapped of files: libraries that are open, files that are memory.
#pragma once

#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>

namespace torrance::test {

/// How many mappings are of a file whose path has this in it.
inline std::size_t mappedLines(std::string_view part)
{
    std::size_t count = 0;
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);)
        count += line.find(part) != std::string::npos ? 1 : 0;
    return count;
}

} // namespace torrance::test
