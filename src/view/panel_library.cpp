#include "view/panel_library.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <cmath>
#include <imgui.h>
#include <set>

namespace torrance {
namespace {

constexpr float kFontPixels = 13.0f; // the size for which the built-in font is drawn

// Dark, quiet, without rounding that a software rasterizer pays for.
void setStyle(float scale)
{
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 0.0f;
    style.WindowBorderSize = 1.0f;
    style.Colors[ImGuiCol_WindowBg] = {0.11f, 0.11f, 0.12f, 0.98f};
    style.Colors[ImGuiCol_TextDisabled] = {0.65f, 0.65f, 0.66f, 1.0f}; // notes are to be read, too
    style.ScaleAllSizes(scale);
}

// Whether a key does something to a text other than adding its letter: those with control, and all without a letter but
// the modifiers themselves.
bool movesCursor(const Window::KeyEvent& event)
{
    const bool modifier = event.key >= GLFW_KEY_LEFT_SHIFT && event.key <= GLFW_KEY_RIGHT_SUPER;
    return !modifier && (event.key >= GLFW_KEY_ESCAPE || (event.modifiers & GLFW_MOD_CONTROL));
}

} // namespace

PanelLibrary::PanelLibrary(Window& w) : window(w)
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // what is kept is kept by us
    ImFontConfig font;
    font.SizePixels = std::round(kFontPixels * window.scale());
    io.Fonts->AddFontDefault(&font);
    setStyle(window.scale());
    ImGui_ImplGlfw_InitForVulkan(window.handle, false); // the keyboard's events go through a list of ours
    // The window's own callbacks hear first.
    static GLFWwindowfocusfun focus = nullptr;
    static GLFWmousebuttonfun button = nullptr;
    static GLFWscrollfun scroll = nullptr;
    focus = glfwSetWindowFocusCallback(window.handle, [](GLFWwindow* handle, int focused) {
        focus(handle, focused);
        ImGui_ImplGlfw_WindowFocusCallback(handle, focused);
    });
    button = glfwSetMouseButtonCallback(window.handle, [](GLFWwindow* handle, int which, int action, int modifiers) {
        button(handle, which, action, modifiers);
        ImGui_ImplGlfw_MouseButtonCallback(handle, which, action, modifiers);
    });
    scroll = glfwSetScrollCallback(window.handle, [](GLFWwindow* handle, double x, double y) {
        scroll(handle, x, y);
        ImGui_ImplGlfw_ScrollCallback(handle, x, y);
    });
    glfwSetCursorEnterCallback(window.handle, ImGui_ImplGlfw_CursorEnterCallback);
}

PanelLibrary::~PanelLibrary()
{
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

std::vector<KeyPress> PanelLibrary::beginPicture()
{
    std::vector<KeyPress> presses;
    std::set<int> moving; // keys that moved the cursor
    while (!window.keyEvents.empty()) {
        const Window::KeyEvent event = window.keyEvents.front();
        if (event.character ? !moving.empty() : moving.contains(event.key))
            break;
        window.keyEvents.pop_front();
        if (event.character) {
            ImGui_ImplGlfw_CharCallback(window.handle, event.character);
            continue;
        }
        ImGui_ImplGlfw_KeyCallback(window.handle, event.key, event.scancode, event.action, event.modifiers);
        if (event.action == GLFW_RELEASE)
            continue;
        if (movesCursor(event))
            moving.insert(event.key);
        presses.push_back({.key = event.key,
                           .shift = (event.modifiers & GLFW_MOD_SHIFT) != 0,
                           .control = (event.modifiers & GLFW_MOD_CONTROL) != 0});
    }
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    return presses;
}

} // namespace torrance
