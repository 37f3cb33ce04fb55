// What the window remembers from one time to the next.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace torrance {

/// $XDG_CONFIG_HOME/torrance, else ~/.config/torrance; empty where neither is set.
std::filesystem::path userConfigFolder();

inline constexpr std::size_t kMostRecent = 10;

/// Files that were opened, newest first. Nothing where there are none, or the file that holds them is damaged.
std::vector<std::string> loadRecent(const std::filesystem::path& configFolder);

/// With `file` in front, as it is kept from now on. A folder that cannot be written is no reason to fail.
std::vector<std::string> keepRecent(const std::filesystem::path& configFolder, std::vector<std::string> recent,
                                    const std::string& file);

} // namespace torrance
