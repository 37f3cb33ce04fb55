#include "view/window.h"

#include "core/error.h"

#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>
#include <utility>

namespace torrance {
namespace {

std::string lastProblem()
{
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? oneLine(text) : "no reason was given";
}

Error noWindow(const std::string& problem)
{
    return {ExitCode::noDevice, "no window can be opened: " + problem + "; 'torrance render' draws without a display"};
}

} // namespace

Window::Window(const std::string& title, const ivec2& size)
{
    if (!glfwInit())
        throw noWindow(lastProblem());
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    handle = glfwVulkanSupported() ? glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr) : nullptr;
    if (!handle) {
        const std::string problem = glfwVulkanSupported() ? lastProblem() : "there is no Vulkan loader";
        glfwTerminate();
        throw noWindow(problem);
    }
    glfwSetWindowUserPointer(handle, this);
    glfwSetKeyCallback(handle, [](GLFWwindow* window, int key, int scancode, int action, int modifiers) {
        of(window).keyEvents.push_back({.key = key, .scancode = scancode, .action = action, .modifiers = modifiers});
    });
    glfwSetCharCallback(handle, [](GLFWwindow* window, unsigned character) {
        of(window).keyEvents.push_back({.character = character});
    });
    glfwSetCursorPosCallback(
        handle, [](GLFWwindow* window, double x, double y) { of(window).arrow = vec2(float(x), float(y)); });
    glfwSetMouseButtonCallback(handle, [](GLFWwindow* window, int button, int action, int) {
        Window& self = of(window);
        if (action == GLFW_PRESS && button < int(self.pressPlaces.size()))
            self.pressPlaces[static_cast<std::size_t>(button)] = self.arrow;
    });
    glfwSetScrollCallback(handle, [](GLFWwindow* window, double, double) { of(window); });
    glfwSetWindowFocusCallback(handle, [](GLFWwindow* window, int) { of(window); });
    glfwSetWindowRefreshCallback(handle, [](GLFWwindow* window) { of(window); });
    glfwSetFramebufferSizeCallback(handle, [](GLFWwindow* window, int, int) { of(window); });
    glfwSetWindowContentScaleCallback(handle, [](GLFWwindow* window, float, float) { of(window); });
    glfwSetDropCallback(handle, [](GLFWwindow* window, int count, const char** paths) {
        Window& self = of(window);
        self.dropped.insert(self.dropped.end(), paths, paths + count);
    });
}

Window& Window::of(GLFWwindow* window)
{
    Window& self = *static_cast<Window*>(glfwGetWindowUserPointer(window));
    self.active = true;
    return self;
}

Window::~Window()
{
    glfwDestroyWindow(handle);
    glfwTerminate();
}

std::vector<std::string> Window::extensions() const
{
    std::uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    if (!names)
        throw noWindow("the Vulkan loader knows no pictures in windows");
    return {names, names + count};
}

vk::raii::SurfaceKHR Window::makeSurface(const gpu::Device& device) const
{
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    if (glfwCreateWindowSurface(*device.instance, handle, nullptr, &surface) != VK_SUCCESS)
        throw noWindow(lastProblem());
    return {device.instance, surface};
}

ivec2 Window::size() const
{
    ivec2 size;
    glfwGetWindowSize(handle, &size.x, &size.y);
    return size;
}

ivec2 Window::sizeWithoutScale() const
{
    // Where a pixel is a unit of the desktop's, GLFW has made the window larger by the scale (GLFW_SCALE_TO_MONITOR).
    const float scaledBy = size() == pixels() ? scale() : 1.0f;
    return ivec2(glm::round(vec2(size()) / scaledBy));
}

ivec2 Window::pixels() const
{
    ivec2 size;
    glfwGetFramebufferSize(handle, &size.x, &size.y);
    return size;
}

float Window::scale() const
{
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(handle, &x, &y);
    return x;
}

void Window::handleEvents(bool wait)
{
    wait ? glfwWaitEvents() : glfwPollEvents();
}

void Window::handleEvents(double seconds)
{
    glfwWaitEventsTimeout(seconds);
}

void Window::wake()
{
    woken = true;
    glfwPostEmptyEvent();
}

void Window::setTitle(const std::string& title)
{
    glfwSetWindowTitle(handle, title.c_str());
}

std::vector<std::filesystem::path> Window::takeDropped()
{
    return std::exchange(dropped, {});
}

bool Window::takeCloseRequest()
{
    const bool asked = glfwWindowShouldClose(handle);
    glfwSetWindowShouldClose(handle, GLFW_FALSE);
    return asked;
}

} // namespace torrance
