// Dear ImGui's context and its half of GLFW, from their beginning to their end.
#pragma once

#include "view/window.h"

namespace torrance {

class PanelLibrary
{
public:
    /// `scale` of text: 1 at 96 dots an inch.
    explicit PanelLibrary(const Window& window);
    ~PanelLibrary();
    PanelLibrary(const PanelLibrary&) = delete;
    PanelLibrary& operator=(const PanelLibrary&) = delete;

    void beginPicture();
};

} // namespace torrance
