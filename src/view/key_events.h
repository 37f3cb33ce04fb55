// What the keyboard did, and how much of it one picture of the panels can tell apart.
#pragma once

#include <deque>
#include <vector>

namespace torrance {

/// What the keyboard did once. In a picture that takes long a press and its end can both lie, so that what is down at
/// its beginning says too little.
struct KeyEvent
{
    int key = 0; // GLFW_KEY_..., or
    unsigned character = 0;
    int scancode = 0;
    int action = 0;    // GLFW_PRESS, ...
    int modifiers = 0; // GLFW_MOD_...
};

/// Takes from the front what Dear ImGui 1.86, which knows no more than what is down when a picture begins, sees as it
/// happened: no key that does something to a text twice, no letter after one, and no other modifier either, which would
/// be held by the keys before it (Ctrl+A may end with Ctrl). The rest is for the next pictures.
std::vector<KeyEvent> takeForOnePicture(std::deque<KeyEvent>& events);

} // namespace torrance
