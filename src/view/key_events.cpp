#include "view/key_events.h"

#include <GLFW/glfw3.h>
#include <set>

namespace torrance {
namespace {

bool isModifier(const KeyEvent& event)
{
    return event.key >= GLFW_KEY_LEFT_SHIFT && event.key <= GLFW_KEY_RIGHT_SUPER;
}

// Whether a key does something to a text other than adding its letter: those with control, and all without a letter but
// the modifiers themselves.
bool editsText(const KeyEvent& event)
{
    return !isModifier(event) && event.action != GLFW_RELEASE &&
           (event.key >= GLFW_KEY_ESCAPE || (event.modifiers & GLFW_MOD_CONTROL));
}

} // namespace

std::vector<KeyEvent> takeForOnePicture(std::deque<KeyEvent>& events)
{
    std::vector<KeyEvent> taken;
    std::set<int> editing; // keys that are down in this picture
    while (!events.empty()) {
        const KeyEvent& event = events.front();
        const bool waits = event.character || isModifier(event) ? !editing.empty() : editing.contains(event.key);
        if (waits)
            break;
        if (editsText(event))
            editing.insert(event.key);
        taken.push_back(event);
        events.pop_front();
    }
    return taken;
}

} // namespace torrance
