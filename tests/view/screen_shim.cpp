// Loaded before GLFW (LD_PRELOAD), for what an X server has not: screens of other scales to move a window to, and
// desktops whose coordinates are not pixels.
//
//   TORRANCE_TEST_SCALE=FILE    the file holds the scale of text, and may change: GLFW tells the window after its next
//   event TORRANCE_TEST_RATIO=N       a unit of the desktop is N pixels, as on Wayland and macOS
#include <GLFW/glfw3.h>
#include <cstdlib>
#include <dlfcn.h>
#include <fstream>
#include <utility>

namespace {

template <typename Function>
Function real(const char* name)
{
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

int ratio()
{
    const char* text = std::getenv("TORRANCE_TEST_RATIO");
    return text ? std::atoi(text) : 1;
}

float testScale()
{
    const char* file = std::getenv("TORRANCE_TEST_SCALE");
    float scale = 1.0f;
    if (file)
        std::ifstream(file) >> scale;
    return scale;
}

GLFWwindow* theWindow = nullptr;
GLFWwindowcontentscalefun onScale = nullptr;
GLFWcursorposfun onCursor = nullptr;
float knownScale = testScale();

void tellScale()
{
    const float now = testScale();
    if (now == knownScale || now <= 0.0f)
        return; // 0: the file is being written
    knownScale = now;
    if (onScale)
        onScale(theWindow, now, now);
}

} // namespace

extern "C" {

void glfwGetWindowContentScale(GLFWwindow*, float* x, float* y)
{
    *x = *y = knownScale;
}

GLFWwindowcontentscalefun glfwSetWindowContentScaleCallback(GLFWwindow* window, GLFWwindowcontentscalefun callback)
{
    theWindow = window;
    return std::exchange(onScale, callback);
}

void glfwPollEvents()
{
    real<void (*)()>("glfwPollEvents")();
    tellScale();
}

void glfwWaitEvents()
{
    real<void (*)()>("glfwWaitEvents")();
    tellScale();
}

void glfwWaitEventsTimeout(double seconds)
{
    real<void (*)(double)>("glfwWaitEventsTimeout")(seconds);
    tellScale();
}

void glfwGetWindowSize(GLFWwindow* window, int* width, int* height)
{
    real<void (*)(GLFWwindow*, int*, int*)>("glfwGetWindowSize")(window, width, height);
    *width /= ratio();
    *height /= ratio();
}

void glfwGetCursorPos(GLFWwindow* window, double* x, double* y)
{
    real<void (*)(GLFWwindow*, double*, double*)>("glfwGetCursorPos")(window, x, y);
    *x /= ratio();
    *y /= ratio();
}

GLFWcursorposfun glfwSetCursorPosCallback(GLFWwindow* window, GLFWcursorposfun callback)
{
    const auto scaled = [](GLFWwindow* w, double x, double y) { onCursor(w, x / ratio(), y / ratio()); };
    real<GLFWcursorposfun (*)(GLFWwindow*, GLFWcursorposfun)>("glfwSetCursorPosCallback")(window, scaled);
    return std::exchange(onCursor, callback);
}

} // extern "C"
