// The pictures that a window shows, one after the other: each is copied from one of ours, so that what is shown can
// also be read.
#pragma once

#include "gpu/commands.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace torrance::gpu {

/// Work that the device may have begun before the oldest must have ended: while a picture is shown, the next is
/// recorded.
inline constexpr std::size_t kFramesInFlight = 2;

class Swapchain
{
public:
    /// Errors (noDevice) where the device cannot show pictures on this surface.
    Swapchain(const Device& device, vk::raii::SurfaceKHR surface);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    /// Of 8-bit codes, in the order of channels that the surface has: B8G8R8A8 or R8G8B8A8.
    vk::Format format() const { return surfaceFormat.format; }

    /// The size of the next picture. Where the window system leaves it to us it is `wanted`. Nothing where the window
    /// has no area (minimised): there is nothing to draw for.
    std::optional<vk::Extent2D> prepare(const vk::Extent2D& wanted);

    /// Records the drawing of a picture; returns what is kept until the device has done with it.
    using Record = std::function<std::vector<Buffer>(Commands&)>;
    /// Shows a picture of the prepared size and of format(), which `record` draws. False where the window changed
    /// meanwhile: prepare again, and draw anew.
    bool show(const DeviceImage& picture, const Record& record);

    /// Until the device has nothing to do: before what it shows goes.
    void waitUntilIdle() const;
    /// The same at the end, where there is nothing left to wait for once the device is lost.
    void waitAtEnd() const noexcept;

private:
    // What one picture in flight uses.
    struct Frame
    {
        std::optional<Commands> commands;
        std::vector<Buffer> keep;
        vk::raii::Semaphore acquired = nullptr;
        vk::raii::Fence done = nullptr;
    };
    void create(const vk::SurfaceCapabilitiesKHR& capabilities, const vk::Extent2D& size);

    const Device& device;
    vk::raii::SurfaceKHR surface;
    vk::SurfaceFormatKHR surfaceFormat;
    vk::raii::SwapchainKHR handle = nullptr;
    vk::Extent2D extent;
    bool outOfDate = true;
    std::vector<vk::Image> images;
    std::vector<AccessHistory> histories;
    std::vector<vk::raii::Semaphore> drawn; // by image: the window system may still wait for the one of the last frame
    std::array<Frame, kFramesInFlight> frames;
    std::size_t next = 0;
};

} // namespace torrance::gpu
