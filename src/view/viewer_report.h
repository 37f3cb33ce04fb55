// What the window shows, as JSON: for scripts that drive it, and for tests.
#pragma once

#include "view/panels.h"
#include "view/viewer_state.h"

#include <string>

namespace torrance {

/// Where the picture is in the window, in its pixels.
struct PictureArea
{
    ivec2 first;
    ivec2 size;
};

std::string viewerReport(const ViewerState& state, const ViewerHost& host, const Places& places,
                         const PictureArea& area);

/// To a file, whole or not at all.
void writeReport(const std::string& file, const std::string& text);

} // namespace torrance
