// What the window shows, in the words of `torrance render`.
#pragma once

#include "view/viewer_state.h"

#include <string>

namespace torrance {

struct RenderCommand
{
    std::string text;              // for a shell, on one line
    std::vector<std::string> lost; // what no option says: changes that must be saved to a file first
};

/// The command whose picture has the bytes of one that is saved from the state. `scene` was opened.
RenderCommand renderCommandOf(const ViewerState& state, const ViewerHost& host);

/// The same as single arguments, the program's name and the command left out.
std::vector<std::string> renderArguments(const ViewerState& state, const ViewerHost& host);

} // namespace torrance
