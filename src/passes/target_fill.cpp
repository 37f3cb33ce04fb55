#include "passes/target_fill.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <vector>

namespace torrance {
namespace {

constexpr std::size_t kTexelBytes = sizeof(vec4); // of kColorFormat and kAttributeFormat
constexpr std::size_t kStripBytes = 256 << 10;    // stays in a processor's cache while it is copied over a picture

bool clearsByItself(const gpu::Device& device)
{
    return !device.description.isProcessor();
}

std::uint32_t rowsOf(std::uint32_t width)
{
    return static_cast<std::uint32_t>(std::max<std::size_t>(1, kStripBytes / (kTexelBytes * width)));
}

void copyOver(gpu::Commands& commands, const gpu::Buffer& texels, std::uint32_t rows, const gpu::DeviceImage& target)
{
    const gpu::ImageShape& shape = target.shape;
    assert(shape.format == kColorFormat || shape.format == kAttributeFormat);
    std::vector<vk::BufferImageCopy> regions;
    for (std::uint32_t y = 0; y < shape.height; y += rows)
        regions.push_back({.imageSubresource = {target.aspect(), 0, 0, 1},
                           .imageOffset = {0, static_cast<std::int32_t>(y), 0},
                           .imageExtent = {shape.width, std::min(rows, shape.height - y), 1}});
    commands.use({gpu::use(target, gpu::Access::transferWrite, true)}, {gpu::use(texels, gpu::Access::transferRead)});
    commands.buffer.copyBufferToImage(*texels.handle, *target.handle, vk::ImageLayout::eTransferDstOptimal, regions);
}

} // namespace

const TargetFill::Strip& TargetFill::stripOf(const vec4& color, std::uint32_t width)
{
    const auto found =
        std::ranges::find_if(strips, [&](const Strip& s) { return s.color == color && s.width == width; });
    if (found != strips.end()) {
        strips.splice(strips.begin(), strips, found);
        return strips.front();
    }
    if (strips.size() == kStrips)
        strips.pop_back();
    const std::uint32_t rows = rowsOf(width);
    gpu::Buffer texels = gpu::makeStagingBuffer(device, std::size_t(rows) * width * kTexelBytes, "fill of targets");
    for (std::size_t i = 0; i < std::size_t(rows) * width; ++i)
        std::memcpy(texels.mapped + i * kTexelBytes, &color, kTexelBytes);
    strips.push_front({.color = color, .width = width, .rows = rows, .texels = std::move(texels)});
    return strips.front();
}

ClearColor TargetFill::fill(gpu::Commands& commands, std::span<const gpu::DeviceImage* const> targets,
                            const ClearColor& color)
{
    if (!color || clearsByItself(device))
        return color;
    const Strip& strip = stripOf(*color, targets.front()->shape.width);
    for (const gpu::DeviceImage* target : targets)
        copyOver(commands, strip.texels, strip.rows, *target);
    return kKeep;
}

} // namespace torrance
