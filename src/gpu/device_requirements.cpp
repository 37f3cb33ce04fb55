#include "gpu/device_requirements.h"

#include "core/mapped_file.h"

#include <algorithm>
#include <array>

namespace torrance::gpu {
namespace {

// One push-descriptor set per pass: bindings are written into the command buffer, no pools to manage.
constexpr std::array kExtensions = {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};

using FeatureChain = vk::StructureChain<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan11Features,
                                        vk::PhysicalDeviceVulkan12Features, vk::PhysicalDeviceVulkan13Features>;

std::string versionText(std::uint32_t version)
{
    return std::to_string(VK_API_VERSION_MAJOR(version)) + "." + std::to_string(VK_API_VERSION_MINOR(version)) + "." +
           std::to_string(VK_API_VERSION_PATCH(version));
}

std::string kindName(vk::PhysicalDeviceType kind)
{
    switch (kind) {
    case vk::PhysicalDeviceType::eDiscreteGpu:
        return "discrete GPU";
    case vk::PhysicalDeviceType::eIntegratedGpu:
        return "integrated GPU";
    case vk::PhysicalDeviceType::eVirtualGpu:
        return "virtual GPU";
    case vk::PhysicalDeviceType::eCpu:
        return "CPU";
    default:
        return "other";
    }
}

bool filtersFloat32(const vk::raii::PhysicalDevice& physical)
{
    const auto features = physical.getFormatProperties(vk::Format::eR32G32B32A32Sfloat).optimalTilingFeatures;
    return bool(features & vk::FormatFeatureFlagBits::eSampledImageFilterLinear);
}

bool blendsFloat32(const vk::raii::PhysicalDevice& physical)
{
    const auto features = physical.getFormatProperties(vk::Format::eR32G32B32A32Sfloat).optimalTilingFeatures;
    return bool(features & vk::FormatFeatureFlagBits::eColorAttachmentBlend);
}

bool hasExtension(const std::vector<vk::ExtensionProperties>& available, const char* extension)
{
    return std::ranges::any_of(available,
                               [&](const auto& e) { return std::string_view(e.extensionName) == extension; });
}

bool drawsDepthStencil(const vk::raii::PhysicalDevice& physical)
{
    const auto features = physical.getFormatProperties(vk::Format::eD32SfloatS8Uint).optimalTilingFeatures;
    constexpr auto kNeeded =
        vk::FormatFeatureFlagBits::eDepthStencilAttachment | vk::FormatFeatureFlagBits::eSampledImage;
    return (features & kNeeded) == kNeeded;
}

// The lights of a scene, and the materials that are shaded together.
constexpr std::uint32_t kUniformBlockBytes = 64 << 10;
// Of a vertex and of its instance: as many as Vulkan requires of every device.
constexpr std::uint32_t kVertexAttributes = 16;

std::vector<std::string> missingParts(const vk::raii::PhysicalDevice& physical)
{
    std::vector<std::string> missing;
    if (physical.getProperties().apiVersion < VK_API_VERSION_1_3)
        return {"Vulkan 1.3"}; // the features below cannot be asked for
    const auto chain = physical.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan12Features,
                                             vk::PhysicalDeviceVulkan13Features>();
    const auto need = [&](bool has, const char* what) {
        if (!has)
            missing.emplace_back(what);
    };
    need(chain.get<vk::PhysicalDeviceVulkan12Features>().scalarBlockLayout, "scalarBlockLayout");
    need(chain.get<vk::PhysicalDeviceVulkan13Features>().dynamicRendering, "dynamicRendering");
    need(chain.get<vk::PhysicalDeviceVulkan13Features>().synchronization2, "synchronization2");
    need(filtersFloat32(physical), "linear filtering of R32G32B32A32_SFLOAT");
    need(blendsFloat32(physical), "blending of R32G32B32A32_SFLOAT");
    const vk::PhysicalDeviceLimits limits = physical.getProperties().limits;
    need(limits.maxUniformBufferRange >= kUniformBlockBytes, "uniform blocks of 64 KiB");
    need(limits.maxVertexInputAttributes >= kVertexAttributes && limits.maxVertexInputBindings >= kVertexAttributes,
         "16 vertex attributes of a binding each");
    need(drawsDepthStencil(physical), "depth and stencil in D32_SFLOAT_S8_UINT");
    need(graphicsQueueFamily(physical).has_value(), "a graphics queue");
    const auto available = physical.enumerateDeviceExtensionProperties();
    for (const char* extension : kExtensions)
        need(hasExtension(available, extension), extension);
    return missing;
}

} // namespace

DeviceDescription describe(const vk::raii::PhysicalDevice& physical)
{
    const auto chain = physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
    const auto& properties = chain.get<vk::PhysicalDeviceProperties2>().properties;
    const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
    return {.name = properties.deviceName,
            .kind = kindName(properties.deviceType),
            .driver = driver.driverName,
            .driverVersion = driver.driverInfo,
            .apiVersion = versionText(properties.apiVersion),
            .missing = missingParts(physical)};
}

std::optional<std::uint32_t> graphicsQueueFamily(const vk::raii::PhysicalDevice& physical)
{
    const auto families = physical.getQueueFamilyProperties();
    for (std::uint32_t i = 0; i < families.size(); ++i)
        if (families[i].queueFlags & vk::QueueFlagBits::eGraphics)
            return i;
    return std::nullopt;
}

bool supports(const vk::raii::PhysicalDevice& physical, Precision precision)
{
    const auto chain = physical.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan11Features,
                                             vk::PhysicalDeviceVulkan12Features>();
    switch (precision) {
    case Precision::fp16: // computed with, and read from buffers
        return chain.get<vk::PhysicalDeviceVulkan12Features>().shaderFloat16 &&
               chain.get<vk::PhysicalDeviceVulkan11Features>().storageBuffer16BitAccess;
    case Precision::fp64:
        return chain.get<vk::PhysicalDeviceFeatures2>().features.shaderFloat64;
    default:
        return true;
    }
}

bool samplesDepth(const vk::raii::PhysicalDevice& physical)
{
    constexpr auto kFour = vk::SampleCountFlagBits::e4;
    const vk::PhysicalDeviceLimits limits = physical.getProperties().limits;
    return limits.standardSampleLocations && (limits.framebufferDepthSampleCounts & kFour) &&
           (limits.sampledImageDepthSampleCounts & kFour) && physical.getFeatures().sampleRateShading;
}

bool importsHostPages(const vk::raii::PhysicalDevice& physical)
{
    if (!hasExtension(physical.enumerateDeviceExtensionProperties(), VK_EXT_EXTERNAL_MEMORY_HOST_EXTENSION_NAME))
        return false;
    const auto chain =
        physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceExternalMemoryHostPropertiesEXT>();
    return chain.get<vk::PhysicalDeviceExternalMemoryHostPropertiesEXT>().minImportedHostPointerAlignment <= kPageBytes;
}

bool supportsSwapchain(const vk::raii::PhysicalDevice& physical)
{
    return hasExtension(physical.enumerateDeviceExtensionProperties(), VK_KHR_SWAPCHAIN_EXTENSION_NAME);
}

vk::raii::Device makeDevice(const vk::raii::PhysicalDevice& physical, std::uint32_t queueFamily, bool shows)
{
    std::vector<const char*> extensions(kExtensions.begin(), kExtensions.end());
    if (importsHostPages(physical))
        extensions.push_back(VK_EXT_EXTERNAL_MEMORY_HOST_EXTENSION_NAME);
    if (shows)
        extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    const float priority = 1.0f;
    const vk::DeviceQueueCreateInfo queueInfo = {
        .queueFamilyIndex = queueFamily, .queueCount = 1, .pQueuePriorities = &priority};
    const bool half = supports(physical, Precision::fp16);
    const FeatureChain features = {
        vk::PhysicalDeviceFeatures2{
            .features = {.sampleRateShading = samplesDepth(physical),
                         .occlusionQueryPrecise = physical.getFeatures().occlusionQueryPrecise, // tests count by it
                         .shaderFloat64 = supports(physical, Precision::fp64)}},
        vk::PhysicalDeviceVulkan11Features{.storageBuffer16BitAccess = half},
        vk::PhysicalDeviceVulkan12Features{.shaderFloat16 = half, .scalarBlockLayout = true},
        vk::PhysicalDeviceVulkan13Features{.synchronization2 = true, .dynamicRendering = true},
    };
    const vk::DeviceCreateInfo info = {.pNext = &features.get<vk::PhysicalDeviceFeatures2>(),
                                       .queueCreateInfoCount = 1,
                                       .pQueueCreateInfos = &queueInfo,
                                       .enabledExtensionCount = static_cast<std::uint32_t>(extensions.size()),
                                       .ppEnabledExtensionNames = extensions.data()};
    return vk::raii::Device(physical, info);
}

} // namespace torrance::gpu
