#include "gpu/device.h"

#include "core/error.h"
#include "gpu/device_requirements.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace torrance::gpu {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

Error noDevice(const std::string& problem, const std::string& remedy)
{
    return {ExitCode::noDevice, problem + "; " + remedy};
}

vk::raii::Context openLoader()
{
    try {
        return vk::raii::Context();
    } catch (const std::exception&) {
        throw noDevice("no Vulkan loader was found",
                       "install the package libvulkan1, and mesa-vulkan-drivers for a machine without a GPU");
    }
}

VKAPI_ATTR VkBool32 VKAPI_CALL collectMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                              const VkDebugUtilsMessengerCallbackDataEXT* data, void* user)
{
    auto& log = *static_cast<ValidationLog*>(user);
    const std::lock_guard lock(log.mutex);
    log.messages.emplace_back(data->pMessage);
    return VK_FALSE;
}

vk::DebugUtilsMessengerCreateInfoEXT messengerInfo(ValidationLog& log)
{
    using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
    // VALIDATION only: layers that the environment enables send GENERAL notes of the loader.
    return {.messageSeverity = Severity::eError | Severity::eWarning,
            .messageType = vk::DebugUtilsMessageTypeFlagBitsEXT::eValidation,
            .pfnUserCallback = collectMessage,
            .pUserData = &log};
}

vk::raii::Instance makeInstance(const vk::raii::Context& context, const DeviceOptions& options, ValidationLog& log)
{
    const bool validation = options.validation;
    if (context.enumerateInstanceVersion() < VK_API_VERSION_1_3)
        throw noDevice("the Vulkan loader is older than 1.3", "install a newer libvulkan1");
    std::vector<const char*> layers;
    std::vector<const char*> extensions;
    for (const std::string& extension : options.windowExtensions)
        extensions.push_back(extension.c_str());
    if (validation) {
        const auto installed = context.enumerateInstanceLayerProperties();
        if (std::ranges::none_of(
                installed, [](const auto& layer) { return std::string_view(layer.layerName) == kValidationLayer; }))
            throw noDevice("the validation layer is not installed", "install the package vulkan-validationlayers");
        layers.push_back(kValidationLayer);
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    }
    const vk::ApplicationInfo application = {.pApplicationName = "torrance", .apiVersion = VK_API_VERSION_1_3};
    const std::array features = {vk::ValidationFeatureEnableEXT::eSynchronizationValidation};
    const auto messages = messengerInfo(log);
    const vk::ValidationFeaturesEXT validationFeatures = {.pNext = &messages,
                                                          .enabledValidationFeatureCount = features.size(),
                                                          .pEnabledValidationFeatures = features.data()};
    const vk::InstanceCreateInfo info = {.pNext = validation ? &validationFeatures : nullptr,
                                         .pApplicationInfo = &application,
                                         .enabledLayerCount = static_cast<std::uint32_t>(layers.size()),
                                         .ppEnabledLayerNames = layers.data(),
                                         .enabledExtensionCount = static_cast<std::uint32_t>(extensions.size()),
                                         .ppEnabledExtensionNames = extensions.data()};
    try {
        return vk::raii::Instance(context, info);
    } catch (const vk::SystemError& error) {
        throw noDevice(std::string("no Vulkan instance could be made: ") + error.what(),
                       "install a Vulkan driver (mesa-vulkan-drivers for a machine without a GPU)");
    }
}

int rankOfKind(vk::PhysicalDeviceType kind)
{
    switch (kind) {
    case vk::PhysicalDeviceType::eDiscreteGpu:
        return 0;
    case vk::PhysicalDeviceType::eIntegratedGpu:
        return 1;
    case vk::PhysicalDeviceType::eVirtualGpu:
        return 2;
    case vk::PhysicalDeviceType::eCpu:
        return 3;
    default:
        return 4;
    }
}

std::string lower(std::string_view text)
{
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

bool isChosen(const DeviceDescription& device, std::size_t index, const std::string& choice)
{
    if (choice.empty())
        return true;
    if (choice == "cpu")
        return device.isProcessor();
    std::size_t number = 0;
    const auto [end, failure] = std::from_chars(choice.data(), choice.data() + choice.size(), number);
    if (failure == std::errc() && end == choice.data() + choice.size())
        return number == index;
    return lower(device.name).find(lower(choice)) != std::string::npos;
}

std::string commaSeparated(const std::vector<std::string>& items)
{
    std::string text;
    for (const std::string& item : items)
        text.append(text.empty() ? "" : ", ").append(item);
    return text;
}

vk::raii::PhysicalDevice choosePhysical(const vk::raii::Instance& instance, const DeviceOptions& options)
{
    const std::string& choice = options.choice;
    auto devices = instance.enumeratePhysicalDevices();
    int best = -1;
    std::string unusable;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        DeviceDescription device = describe(devices[i]);
        if (!isChosen(device, i, choice))
            continue;
        if (!options.windowExtensions.empty() && !supportsSwapchain(devices[i]))
            device.missing.emplace_back("pictures in windows (VK_KHR_swapchain)");
        if (!device.missing.empty()) {
            unusable = device.name + " lacks " + commaSeparated(device.missing);
            continue;
        }
        const auto rank = [&](std::size_t d) { return rankOfKind(devices[d].getProperties().deviceType); };
        if (best < 0 || rank(i) < rank(static_cast<std::size_t>(best)))
            best = static_cast<int>(i);
    }
    if (best >= 0)
        return std::move(devices[static_cast<std::size_t>(best)]);
    if (!unusable.empty())
        throw noDevice("no usable Vulkan device: " + unusable,
                       "choose another with --device, or install mesa-vulkan-drivers");
    if (devices.empty() || choice.empty())
        throw noDevice("no Vulkan device was found",
                       "install a driver (mesa-vulkan-drivers for a machine without a GPU)");
    throw noDevice("no Vulkan device is called '" + choice + "'", "'torrance devices' lists them");
}

} // namespace

std::vector<DeviceDescription> listDevices()
{
    ValidationLog unused;
    const vk::raii::Context context = openLoader();
    const vk::raii::Instance instance = makeInstance(context, {}, unused);
    std::vector<DeviceDescription> list;
    for (const auto& device : instance.enumeratePhysicalDevices())
        list.push_back(describe(device));
    return list;
}

Device::Device(const DeviceOptions& options)
    : validationLog(std::make_unique<ValidationLog>()), context(openLoader()),
      instance(makeInstance(context, options, *validationLog)),
      messenger(options.validation ? vk::raii::DebugUtilsMessengerEXT(instance, messengerInfo(*validationLog))
                                   : vk::raii::DebugUtilsMessengerEXT(nullptr)),
      physical(choosePhysical(instance, options)), queueFamily(*graphicsQueueFamily(physical)),
      handle(makeDevice(physical, queueFamily, !options.windowExtensions.empty())), queue(handle, queueFamily, 0),
      queueMutex(std::make_unique<std::mutex>()), memory(physical.getMemoryProperties()),
      limits(physical.getProperties().limits), description(describe(physical))
{
}

std::vector<std::string> Device::validationMessages() const
{
    const std::lock_guard lock(validationLog->mutex);
    return validationLog->messages;
}

bool Device::computes(Precision precision) const
{
    return supports(physical, precision);
}

bool Device::samplesDepth() const
{
    return gpu::samplesDepth(physical);
}

bool Device::importsHostPages() const
{
    return gpu::importsHostPages(physical);
}

std::uint32_t Device::memoryType(std::uint32_t allowedTypes, vk::MemoryPropertyFlags wanted,
                                 vk::MemoryPropertyFlags preferred) const
{
    for (const vk::MemoryPropertyFlags flags : {wanted | preferred, wanted})
        for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i)
            if ((allowedTypes >> i & 1u) && (memory.memoryTypes[i].propertyFlags & flags) == flags)
                return i;
    throw Error(ExitCode::deviceFailure,
                description.name + ": no memory type for " + vk::to_string(wanted) + "; choose another device");
}

void Device::nameObject(vk::ObjectType type, std::uint64_t object, std::string_view text) const
{
    if (!*messenger)
        return; // names are seen through VK_EXT_debug_utils, which is on with validation
    const std::string name(text);
    handle.setDebugUtilsObjectNameEXT({.objectType = type, .objectHandle = object, .pObjectName = name.c_str()});
}

} // namespace torrance::gpu
