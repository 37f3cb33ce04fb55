// What the window remembers from one time to the next.
#pragma once

#include "math/vector.h"
#include "plan/tolerance.h"

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

/// What of the window's own is as it was left.
struct KeptSettings
{
    ivec2 windowSize = ivec2(0); // Window::sizeWithoutScale; 0: none is kept
    bool showPanels = true;
    int turntableFrames = 36;
    double tolerance = Tolerance().mean; // that methods are looked for with
    double lampSpeed = 30.0;             // degrees a second

    bool operator==(const KeptSettings&) const = default;
};

// What the panels offer.
inline constexpr int kLeastTurntableFrames = 2, kMostTurntableFrames = 360;
inline constexpr double kLeastTolerance = 0.001, kMostTolerance = 0.1;
inline constexpr double kMostLampSpeed = 180.0; // either way

/// As for loadRecent: those above where there are none. A number out of its range is its default.
KeptSettings loadSettings(const std::filesystem::path& configFolder);

/// A folder that cannot be written is no reason to fail.
void keepSettings(const std::filesystem::path& configFolder, const KeptSettings& settings);

} // namespace torrance
