#include "passes/targets.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace torrance {
namespace {

constexpr std::size_t kTexelBytes = 4 * sizeof(float); // of a colour

vk::RenderingAttachmentInfo attachment(const gpu::DeviceImage& image, vk::ImageLayout layout, bool clears,
                                       const vk::ClearValue& value)
{
    return {.imageView = *image.view,
            .imageLayout = layout,
            .loadOp = clears ? vk::AttachmentLoadOp::eClear : vk::AttachmentLoadOp::eLoad,
            .storeOp = vk::AttachmentStoreOp::eStore,
            .clearValue = value};
}

vk::ClearValue clearValueOf(const ClearColor& color)
{
    const vec4 value = color.value_or(vec4(0.0f));
    return vk::ClearColorValue(std::array{value.r, value.g, value.b, value.a});
}

constexpr auto kColorUsage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eSampled |
                             vk::ImageUsageFlagBits::eTransferSrc | vk::ImageUsageFlagBits::eTransferDst;

// Whether colours lie row by row in the host's memory, where it reads them without a copy: a processor's driver draws
// into rows as well as into anything else.
bool drawsIntoRows(const gpu::Device& device)
{
    if (!device.description.isProcessor())
        return false;
    constexpr auto kNeeded = vk::FormatFeatureFlagBits::eColorAttachment | vk::FormatFeatureFlagBits::eSampledImage;
    if ((device.physical.getFormatProperties(kColorFormat).linearTilingFeatures & kNeeded) != kNeeded)
        return false;
    try {
        const vk::ImageFormatProperties limits = device.physical.getImageFormatProperties(
            kColorFormat, vk::ImageType::e2D, vk::ImageTiling::eLinear, kColorUsage);
        return std::min(limits.maxExtent.width, limits.maxExtent.height) >= device.limits.maxImageDimension2D;
    } catch (const vk::FormatNotSupportedError&) {
        return false;
    }
}

void copyRows(const gpu::DeviceImage& target, Image& image)
{
    const vk::SubresourceLayout layout = target.handle.getSubresourceLayout({vk::ImageAspectFlagBits::eColor, 0, 0});
    const auto* mapped = static_cast<const std::byte*>(target.memory.mapMemory(0, VK_WHOLE_SIZE));
    for (int y = 0; y < image.height; ++y)
        std::memcpy(image.at(0, y), mapped + layout.offset + static_cast<std::size_t>(y) * layout.rowPitch,
                    static_cast<std::size_t>(image.width) * kTexelBytes);
    target.memory.unmapMemory();
}

} // namespace

gpu::DeviceImage makeColorTarget(const gpu::Device& device, int width, int height, const char* name)
{
    return gpu::makeImage(device,
                          {.width = static_cast<std::uint32_t>(width),
                           .height = static_cast<std::uint32_t>(height),
                           .format = kColorFormat},
                          kColorUsage, name, drawsIntoRows(device) ? gpu::ImageTiling::rows : gpu::ImageTiling::device);
}

gpu::DeviceImage makeDepthTarget(const gpu::Device& device, int width, int height, const char* name)
{
    return gpu::makeImage(device,
                          {.width = static_cast<std::uint32_t>(width),
                           .height = static_cast<std::uint32_t>(height),
                           .format = kDepthFormat},
                          vk::ImageUsageFlagBits::eDepthStencilAttachment | vk::ImageUsageFlagBits::eSampled, name);
}

gpu::DeviceImage makeSampleDepthTarget(const gpu::Device& device, int width, int height)
{
    return gpu::makeImage(device,
                          {.width = static_cast<std::uint32_t>(width),
                           .height = static_cast<std::uint32_t>(height),
                           .samples = vk::SampleCountFlagBits::e4,
                           .format = kDepthFormat},
                          vk::ImageUsageFlagBits::eDepthStencilAttachment | vk::ImageUsageFlagBits::eSampled,
                          "depth of samples");
}

gpu::DeviceImage makeDepthStencilTarget(const gpu::Device& device, int width, int height)
{
    using Usage = vk::ImageUsageFlagBits;
    return gpu::makeImage(device,
                          {.width = static_cast<std::uint32_t>(width),
                           .height = static_cast<std::uint32_t>(height),
                           .format = kDepthStencilFormat},
                          Usage::eDepthStencilAttachment | Usage::eSampled, "depth and classes");
}

void beginRendering(gpu::Commands& commands, std::span<const gpu::DeviceImage* const> colors,
                    const gpu::DeviceImage* depth, const ClearColor& clearColor, LoadTarget loadDepth)
{
    std::vector<gpu::ImageUse> uses;
    std::vector<vk::RenderingAttachmentInfo> attachments;
    for (const gpu::DeviceImage* color : colors) {
        uses.push_back(gpu::use(*color, gpu::Access::colorAttachment, clearColor.has_value()));
        attachments.push_back(attachment(*color, vk::ImageLayout::eColorAttachmentOptimal, clearColor.has_value(),
                                         clearValueOf(clearColor)));
    }
    vk::RenderingAttachmentInfo depthAttachment;
    if (depth) {
        const bool reads = loadDepth == LoadTarget::readOnly;
        uses.push_back(gpu::use(*depth, reads ? gpu::Access::depthTest : gpu::Access::depthAttachment,
                                loadDepth == LoadTarget::clear));
        depthAttachment = attachment(*depth,
                                     reads ? vk::ImageLayout::eDepthStencilReadOnlyOptimal
                                           : vk::ImageLayout::eDepthStencilAttachmentOptimal,
                                     loadDepth == LoadTarget::clear, {}); // 0: infinitely far, no class
    }
    commands.use(uses);
    const gpu::ImageShape& shape = (colors.empty() ? depth : colors.front())->shape;
    const vk::Rect2D area = {{0, 0}, {shape.width, shape.height}};
    commands.buffer.beginRendering(
        {.renderArea = area,
         .layerCount = 1,
         .colorAttachmentCount = static_cast<std::uint32_t>(attachments.size()),
         .pColorAttachments = attachments.data(),
         .pDepthAttachment = depth ? &depthAttachment : nullptr,
         .pStencilAttachment = depth && gpu::hasStencil(depth->shape.format) ? &depthAttachment : nullptr});
    commands.buffer.setViewport(
        0, vk::Viewport{0.0f, 0.0f, static_cast<float>(shape.width), static_cast<float>(shape.height), 0.0f, 1.0f});
    commands.buffer.setScissor(0, area);
    commands.buffer.setCullMode(vk::CullModeFlagBits::eNone);
    commands.buffer.setFrontFace(vk::FrontFace::eCounterClockwise);
}

Image readBack(const gpu::Device& device, const gpu::DeviceImage& target)
{
    const gpu::ImageShape& shape = target.shape;
    Image image(static_cast<int>(shape.width), static_cast<int>(shape.height), 4);
    if (drawsIntoRows(device)) {
        gpu::Commands commands(device);
        commands.use({gpu::use(target, gpu::Access::hostRead)});
        commands.submitAndWait();
        copyRows(target, image);
        return image;
    }
    const gpu::Buffer buffer =
        gpu::makeReadbackBuffer(device, vk::DeviceSize(shape.width) * shape.height * kTexelBytes, "readback");
    gpu::Commands commands(device);
    gpu::copyToBuffer(commands, target, buffer);
    commands.submitAndWait();
    std::memcpy(image.texels.data(), buffer.mapped, image.texels.size() * sizeof(float));
    return image;
}

gpu::DeviceImage makeCodeTarget(const gpu::Device& device, vk::Format format, int width, int height, const char* name)
{
    return gpu::makeImage(
        device,
        {.width = static_cast<std::uint32_t>(width), .height = static_cast<std::uint32_t>(height), .format = format},
        vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferSrc, name);
}

CodeImage readCodes(const gpu::Device& device, const gpu::DeviceImage& target)
{
    const gpu::ImageShape& shape = target.shape;
    CodeImage image = {.width = static_cast<int>(shape.width), .height = static_cast<int>(shape.height), .codes = {}};
    image.codes.resize(std::size_t(shape.width) * shape.height * 4);
    const gpu::Buffer buffer = gpu::makeReadbackBuffer(device, image.codes.size(), "codes");
    gpu::Commands commands(device);
    gpu::copyToBuffer(commands, target, buffer);
    commands.submitAndWait();
    std::memcpy(image.codes.data(), buffer.mapped, image.codes.size());
    if (shape.format == vk::Format::eB8G8R8A8Unorm)
        for (std::size_t i = 0; i < image.codes.size(); i += 4)
            std::swap(image.codes[i], image.codes[i + 2]);
    return image;
}

} // namespace torrance
