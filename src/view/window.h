// A window of the desktop: GLFW ends here.
#pragma once

#include "gpu/device.h"
#include "math/vector.h"
#include "view/key_events.h"

#include <array>
#include <atomic>
#include <deque>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace torrance {

class Window
{
public:
    /// Error (noDevice) where there is no display: it names what draws without one.
    Window(const std::string& title, const ivec2& size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Instance extensions that a device needs to show pictures here.
    std::vector<std::string> extensions() const;
    vk::raii::SurfaceKHR makeSurface(const gpu::Device& device) const;

    ivec2 size() const;             // of its inside, in the desktop's coordinates
    ivec2 sizeWithoutScale() const; // the same as the constructor takes it: some desktops' coordinates are scaled
    ivec2 pixels() const;           // of its inside; 0 while it is minimised
    float scale() const; // of text: 1 at 96 dots an inch; another where the window is moved to another screen

    /// Handles what has happened; with `wait`, not before something has, or wake() was called.
    void handleEvents(bool wait);
    /// The same, for at most so many seconds.
    void handleEvents(double seconds);
    /// Ends a wait of another thread, and is something that has happened: where that thread did not wait, the event
    /// alone would be gone with the picture that it is making.
    static void wake();

    void setTitle(const std::string& title);

    /// What the keyboard did, in its order: whoever takes the events decides how many one picture can take.
    std::deque<KeyEvent> keyEvents;

    /// Whether something has happened since the last call.
    bool takeActivity()
    {
        const bool wasWoken = woken.exchange(false);
        return std::exchange(active, false) || wasWoken;
    }

    /// Where the arrow was when a button was pressed last, in the window's coordinates: by the time a picture is made
    /// it may be somewhere else.
    std::array<vec2, 3> pressPlaces = {};
    vec2 arrow = vec2(0.0f); // as of the last event

    /// Files that were dropped on the window since the last call.
    std::vector<std::filesystem::path> takeDropped();
    /// Whether it was asked to close since the last call.
    bool takeCloseRequest();

    GLFWwindow* handle = nullptr; // for Dear ImGui's half of GLFW

private:
    static Window& of(GLFWwindow* window); // and something happens in it
    bool active = true;
    static inline std::atomic<bool> woken = false;
    std::vector<std::filesystem::path> dropped;
};

} // namespace torrance
