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

    /// Begins a picture of the panels, in which as much of the window's keyboard counts as one picture can tell apart
    /// (takeForOnePicture); the rest is left for the next. What was pressed.
    std::vector<KeyPress> beginPicture();

    /// Follows the window's scale: true where the fonts are others now, which have to be uploaded. Between two
    /// pictures.
    bool followScale();

private:
    void makeFonts();

    Window& window;
    float scale;
};

} // namespace torrance
