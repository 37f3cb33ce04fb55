#include "passes/sampler.h"

namespace torrance {
namespace {

using Mode = vk::SamplerAddressMode;

Mode addressMode(Wrap wrap)
{
    switch (wrap) {
    case Wrap::repeat:
        return Mode::eRepeat;
    case Wrap::mirroredRepeat:
        return Mode::eMirroredRepeat;
    case Wrap::clampToEdge:
        return Mode::eClampToEdge;
    }
    return Mode::eRepeat;
}

vk::Filter filterMode(Filter filter)
{
    return filter == Filter::nearest ? vk::Filter::eNearest : vk::Filter::eLinear;
}

vk::raii::Sampler trilinear(const gpu::Device& device, Mode u, Mode v, const char* name)
{
    vk::raii::Sampler sampler(device.handle, vk::SamplerCreateInfo{.magFilter = vk::Filter::eLinear,
                                                                   .minFilter = vk::Filter::eLinear,
                                                                   .mipmapMode = vk::SamplerMipmapMode::eLinear,
                                                                   .addressModeU = u,
                                                                   .addressModeV = v,
                                                                   .addressModeW = Mode::eClampToEdge,
                                                                   .maxLod = VK_LOD_CLAMP_NONE});
    device.name(sampler, name);
    return sampler;
}

} // namespace

vk::raii::Sampler makeSampler(const gpu::Device& device, const Sampler& sampler, float lodBias)
{
    // Without mips, Vulkan's way to say "level 0 with both filters" (VkSamplerCreateInfo, note on OpenGL's modes).
    constexpr float kLevelZero = 0.25f;
    const bool mips = sampler.mip != MipFilter::none;
    vk::raii::Sampler handle(device.handle, vk::SamplerCreateInfo{.magFilter = filterMode(sampler.magnify),
                                                                  .minFilter = filterMode(sampler.minify),
                                                                  .mipmapMode = sampler.mip == MipFilter::linear
                                                                                    ? vk::SamplerMipmapMode::eLinear
                                                                                    : vk::SamplerMipmapMode::eNearest,
                                                                  .addressModeU = addressMode(sampler.wrapS),
                                                                  .addressModeV = addressMode(sampler.wrapT),
                                                                  .addressModeW = Mode::eRepeat,
                                                                  .mipLodBias = mips ? lodBias : 0.0f,
                                                                  .maxLod = mips ? VK_LOD_CLAMP_NONE : kLevelZero});
    device.name(handle, "texture sampler");
    return handle;
}

vk::raii::Sampler makeTableSampler(const gpu::Device& device)
{
    return trilinear(device, Mode::eClampToEdge, Mode::eClampToEdge, "table sampler");
}

vk::raii::Sampler makePanoramaSampler(const gpu::Device& device)
{
    return trilinear(device, Mode::eRepeat, Mode::eClampToEdge, "panorama sampler");
}

vk::raii::Sampler makePointSampler(const gpu::Device& device)
{
    vk::raii::Sampler sampler(device.handle, vk::SamplerCreateInfo{.addressModeU = Mode::eClampToEdge,
                                                                   .addressModeV = Mode::eClampToEdge,
                                                                   .addressModeW = Mode::eClampToEdge});
    device.name(sampler, "point sampler");
    return sampler;
}

} // namespace torrance
