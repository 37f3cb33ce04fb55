// What a loader has to say besides the scene.
#pragma once

#include "core/error.h"

#include <algorithm>
#include <string>
#include <vector>

namespace torrance {

inline constexpr std::size_t kMaxWarnings = 100;

struct LoadReport
{
    std::string file; // as messages name it
    std::vector<std::string> warnings;
    std::size_t nonFiniteNumbers = 0; // NaN and Inf, replaced

    /// Each line once; a file with faults without end is cut off at kMaxWarnings.
    void warn(const std::string& item, const std::string& text)
    {
        addLine(oneLine(file + ": " + (item.empty() ? "" : item + ": ") + text));
    }

    /// Takes over what was said of another file on the way.
    void add(const LoadReport& other)
    {
        nonFiniteNumbers += other.nonFiniteNumbers;
        for (const std::string& warning : other.warnings)
            addLine(warning);
    }

    [[noreturn]] void fail(const std::string& item, const std::string& problem, const std::string& remedy) const
    {
        throw inputError(file, item, problem, remedy);
    }

private:
    void addLine(const std::string& line)
    {
        if (warnings.size() < kMaxWarnings && std::find(warnings.begin(), warnings.end(), line) == warnings.end())
            warnings.push_back(warnings.size() + 1 < kMaxWarnings ? line : file + ": further warnings are not listed");
    }
};

inline constexpr const char* kRepair = "repair or export the file again";

/// "/meshes/3", the way every message names an item of the document.
inline std::string itemName(const char* array, std::size_t index)
{
    return "/" + std::string(array) + "/" + std::to_string(index);
}

} // namespace torrance
