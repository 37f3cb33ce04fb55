#include "passes/dfg_upload.h"

#include "core/data_folder.h"
#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "prepare/dfg_storage.h"

namespace torrance {
namespace {

vk::Format formatOf(brdf::DfgFormat format)
{
    switch (format) {
    case brdf::DfgFormat::float32:
        return vk::Format::eR32G32B32A32Sfloat;
    case brdf::DfgFormat::float16:
        return vk::Format::eR16G16B16A16Sfloat;
    case brdf::DfgFormat::unorm16:
        break;
    }
    return vk::Format::eR16G16B16A16Unorm;
}

gpu::DeviceImage upload(const gpu::Device& device, const DfgTable& table, brdf::DfgFormat format)
{
    using Usage = vk::ImageUsageFlagBits;
    const std::vector<std::byte> texels = packDfg(table, format);
    gpu::DeviceImage image = gpu::makeImage(device,
                                            {.width = static_cast<std::uint32_t>(table.width),
                                             .height = static_cast<std::uint32_t>(table.height),
                                             .format = formatOf(format)},
                                            Usage::eSampled | Usage::eTransferDst, "directional albedos");
    const gpu::Buffer staging = gpu::makeStagingBuffer(device, texels, "directional albedos");
    gpu::Commands commands(device);
    gpu::copyToImage(commands, staging, image, texels.size() / (table.texels.size() / 4));
    commands.submitAndWait();
    return image;
}

} // namespace

gpu::DeviceImage uploadDfgTable(const gpu::Device& device, const brdf::DfgStorage& storage)
{
    const DfgTable built = readDfgTable(dataFolder() / "dfg_ggx_smith_corr.bin");
    return upload(device, dfgWithNodes(built, storage.width, storage.height), storage.format);
}

gpu::DeviceImage uploadIntegrationMap(const gpu::Device& device)
{
    return upload(device, readDfgTable(dataFolder() / "dfg_ggx_burley.bin"), brdf::DfgFormat::float32);
}

} // namespace torrance
