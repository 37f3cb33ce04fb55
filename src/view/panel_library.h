// Dear ImGui's context and its half of GLFW, from their beginning to their end.
#pragma once

#include "view/window.h"

#include <vector>

namespace torrance {

/// A key that was pressed, or repeated while held.
struct KeyPress
{
    int key = 0; // GLFW_KEY_...
    bool shift = false, control = false;
};

class PanelLibrary
{
public:
    explicit PanelLibrary(Window& window);
    ~PanelLibrary();
    PanelLibrary(const PanelLibrary&) = delete;
    PanelLibrary& operator=(const PanelLibrary&) = delete;

    /// Begins a picture of the panels, in which as much of the window's keyboard counts as version 1.86 can tell apart:
    /// no key that moves a text's cursor twice, and no text after one. The rest is left for the next picture. What was
    /// pressed.
    std::vector<KeyPress> beginPicture();

private:
    Window& window;
};

} // namespace torrance
