#include "view/panel_library.h"

#include <backends/imgui_impl_glfw.h>
#include <cmath>
#include <imgui.h>

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

} // namespace

PanelLibrary::PanelLibrary(const Window& window)
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // what is kept is kept by us
    ImFontConfig font;
    font.SizePixels = std::round(kFontPixels * window.scale());
    io.Fonts->AddFontDefault(&font);
    setStyle(window.scale());
    ImGui_ImplGlfw_InitForVulkan(window.handle, true);
}

PanelLibrary::~PanelLibrary()
{
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void PanelLibrary::beginPicture()
{
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

} // namespace torrance
