#include "passes/image_fill.h"

#include "gpu/buffer.h"
#include "gpu/commands.h"

#include <algorithm>
#include <vector>

namespace torrance {
namespace {

/// Of the buffer on the way: large enough that a submission counts for little, small enough for a processor's cache.
constexpr std::size_t kStagingBytes = 512 << 10;

/// Rows of one layer of one mip.
struct Band
{
    std::uint32_t mip, layer, width, firstRow, rows;

    std::size_t bytes(std::size_t bytesPerTexel) const { return std::size_t(width) * rows * bytesPerTexel; }
};

std::vector<Band> bandsOf(const gpu::ImageShape& shape, std::size_t bytesPerTexel)
{
    std::vector<Band> bands;
    for (std::uint32_t mip = 0; mip < shape.mips; ++mip) {
        const std::uint32_t width = std::max(shape.width >> mip, 1u), height = std::max(shape.height >> mip, 1u);
        const auto rows = static_cast<std::uint32_t>(std::max<std::size_t>(1, kStagingBytes / (width * bytesPerTexel)));
        for (std::uint32_t layer = 0; layer < shape.layers; ++layer)
            for (std::uint32_t row = 0; row < height; row += rows)
                bands.push_back({mip, layer, width, row, std::min(rows, height - row)});
    }
    return bands;
}

void copyBands(const gpu::Device& device, const gpu::Buffer& staging, const gpu::DeviceImage& image,
               std::span<const Band> bands, std::size_t bytesPerTexel, bool first, bool last)
{
    std::vector<vk::BufferImageCopy> regions;
    std::size_t offset = 0;
    for (const Band& band : bands) {
        regions.push_back({.bufferOffset = offset,
                           .imageSubresource = {image.aspect(), band.mip, band.layer, 1},
                           .imageOffset = {0, static_cast<std::int32_t>(band.firstRow), 0},
                           .imageExtent = {band.width, band.rows, 1}});
        offset += band.bytes(bytesPerTexel);
    }
    gpu::Commands commands(device);
    commands.use({gpu::use(image, gpu::Access::transferWrite, first)}, {gpu::use(staging, gpu::Access::transferRead)});
    commands.buffer.copyBufferToImage(*staging.handle, *image.handle, vk::ImageLayout::eTransferDstOptimal, regions);
    if (last)
        commands.use({gpu::use(image, gpu::Access::sampled)});
    commands.submitAndWait();
}

} // namespace

bool fillImage(const gpu::Device& device, const gpu::DeviceImage& image, std::size_t bytesPerTexel,
               const std::function<bool(std::span<std::byte>)>& next)
{
    const std::vector<Band> bands = bandsOf(image.shape, bytesPerTexel);
    std::size_t capacity = kStagingBytes; // a single row may need more
    for (const Band& band : bands)
        capacity = std::max(capacity, band.bytes(bytesPerTexel));
    const gpu::Buffer staging = gpu::makeStagingBuffer(device, capacity, "texels on their way");
    for (std::size_t begin = 0, end = 0; begin < bands.size(); begin = end) {
        std::size_t bytes = 0;
        while (end < bands.size() && bytes + bands[end].bytes(bytesPerTexel) <= capacity)
            bytes += bands[end++].bytes(bytesPerTexel);
        if (!next({staging.mapped, bytes}))
            return false;
        copyBands(device, staging, image, std::span(bands).subspan(begin, end - begin), bytesPerTexel, begin == 0,
                  end == bands.size());
    }
    return true;
}

} // namespace torrance
