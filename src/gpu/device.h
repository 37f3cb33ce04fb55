// A Vulkan 1.3 device with one queue, chosen by name, number or kind.
#pragma once

#include "gpu/precision.h"
#include "gpu/vulkan.h"

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace torrance::gpu {

struct DeviceOptions
{
    /// "" = the best (discrete, integrated, virtual, CPU), "cpu" = a software driver, a number of the list, or a part
    /// of a name.
    std::string choice;
    /// Validation and synchronization validation; a missing layer is an Error (noDevice).
    bool validation = false;
    /// Instance extensions of the window system, for a device whose pictures are shown in a window; empty: they are
    /// not.
    std::vector<std::string> windowExtensions = {};
};

/// What stands in the way of using a device; `missing` is empty for one that can be used.
struct DeviceDescription
{
    std::string name;
    std::string kind; // "discrete GPU", "integrated GPU", "virtual GPU", "CPU", "other"
    std::string driver;
    std::string driverVersion;
    std::string apiVersion;
    std::vector<std::string> missing;

    /// A software driver: its memory is the host's, and the host's cores draw.
    bool isProcessor() const { return kind == "CPU"; }
};

/// All devices of this machine, in Vulkan's order. Error (noDevice) where there is no Vulkan loader.
std::vector<DeviceDescription> listDevices();

/// Messages of the validation layer, collected from whatever thread they come.
struct ValidationLog
{
    std::mutex mutex;
    std::vector<std::string> messages;
};

/// Called with every command buffer when its recording has begun and before it ends: tests count the device's work so.
struct CommandHooks
{
    std::function<void(const vk::raii::CommandBuffer&)> begun, ending;
};

class Device
{
public:
    explicit Device(const DeviceOptions& options);

    /// Gives a Vulkan object the name that validation messages and debuggers show.
    template <typename Handle>
    void name(const Handle& object, std::string_view text) const
    {
        nameObject(Handle::objectType, reinterpret_cast<std::uint64_t>(static_cast<typename Handle::CType>(*object)),
                   text);
    }

    std::vector<std::string> validationMessages() const;
    /// Whether shaders may compute in this precision and read it from buffers.
    bool computes(Precision precision) const;
    /// Whether depth can be drawn for four samples of a pixel, at Vulkan's standard places.
    bool samplesDepth() const;
    /// Whether makeImageOver() takes the host's pages.
    bool importsHostPages() const;
    std::uint32_t memoryType(std::uint32_t allowedTypes, vk::MemoryPropertyFlags wanted,
                             vk::MemoryPropertyFlags preferred) const;

    // In order of creation; destroyed in reverse.
    std::unique_ptr<ValidationLog> validationLog;
    vk::raii::Context context;
    vk::raii::Instance instance;
    vk::raii::DebugUtilsMessengerEXT messenger;
    vk::raii::PhysicalDevice physical;
    std::uint32_t queueFamily;
    vk::raii::Device handle;
    vk::raii::Queue queue;
    std::unique_ptr<std::mutex> queueMutex; // held while something is submitted: scenes are uploaded beside a window
    vk::PhysicalDeviceMemoryProperties memory;
    vk::PhysicalDeviceLimits limits;
    DeviceDescription description;
    CommandHooks hooks;

private:
    void nameObject(vk::ObjectType type, std::uint64_t object, std::string_view text) const;
};

} // namespace torrance::gpu
