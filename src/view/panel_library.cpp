#include "view/panel_library.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <cmath>
#include <imgui.h>

namespace torrance {
namespace {

constexpr float kFontPixels = 13.0f; // the size for which the built-in font is drawn

// Dark, quiet, without rounding that a software rasterizer pays for.
void setStyle(float scale)
{
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle(); // what follows scales what is there
    ImGui::StyleColorsDark();
    style.WindowRounding = 0.0f;
    style.WindowBorderSize = 1.0f;
    style.AntiAliasedLines = false; // where a unit is two pixels, a border's soft edge would lie on the picture
    style.Colors[ImGuiCol_WindowBg] = {0.11f, 0.11f, 0.12f, 0.98f};
    style.Colors[ImGuiCol_TextDisabled] = {0.65f, 0.65f, 0.66f, 1.0f}; // notes are to be read, too
    style.ScaleAllSizes(scale);
}

} // namespace

PanelLibrary::PanelLibrary(Window& w) : window(w), scale(w.scale())
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // what is kept is kept by us
    makeFonts();
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

void PanelLibrary::makeFonts()
{
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    ImFontConfig font;
    font.SizePixels = std::round(kFontPixels * scale);
    fonts.AddFontDefault(&font);
    setStyle(scale);
}

bool PanelLibrary::followScale()
{
    if (window.scale() == scale)
        return false;
    scale = window.scale();
    makeFonts();
    return true;
}

PanelLibrary::~PanelLibrary()
{
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

std::vector<KeyPress> PanelLibrary::beginPicture()
{
    std::vector<KeyPress> presses;
    for (const KeyEvent& event : takeForOnePicture(window.keyEvents)) {
        if (event.character) {
            ImGui_ImplGlfw_CharCallback(window.handle, event.character);
            continue;
        }
        ImGui_ImplGlfw_KeyCallback(window.handle, event.key, event.scancode, event.action, event.modifiers);
        if (event.action != GLFW_RELEASE)
            presses.push_back({.key = event.key,
                               .shift = (event.modifiers & GLFW_MOD_SHIFT) != 0,
                               .control = (event.modifiers & GLFW_MOD_CONTROL) != 0});
    }
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    return presses;
}

} // namespace torrance
