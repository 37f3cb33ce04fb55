#include "passes/deferred_pass.h"

#include "passes/targets.h"
#include "shaders/shared/bindings.h"

namespace torrance {

std::vector<gpu::DeviceImage> makeGBuffer(const gpu::Device& device, int width, int height)
{
    std::vector<gpu::DeviceImage> gbuffer;
    for (std::size_t i = 0; i < kGBufferTargets; ++i)
        gbuffer.push_back(makeColorTarget(device, width, height, "G-buffer"));
    return gbuffer;
}

LightingForm lightingForm(const ShadingPlan& plan, std::size_t lightingClass)
{
    const ShaderKey& key = plan.lightingClasses[lightingClass];
    std::vector<std::uint32_t> constants = shadingConstants(plan, key);
    constants.push_back(static_cast<std::uint32_t>(lightingClass));
    return {.selected = selectedText(plan, key),
            .description = {.name = "lighting",
                            .colorFormats = {kColorFormat},
                            .depthFormat = kDepthFormat,
                            .constants = std::move(constants)}};
}

void bindGBuffer(gpu::Bindings& bindings, const std::vector<gpu::DeviceImage>& gbuffer,
                 const vk::raii::Sampler& sampler)
{
    for (std::size_t i = 0; i < gbuffer.size(); ++i)
        bindings.set(shared::kBindGBuffer + static_cast<std::uint32_t>(i), gbuffer[i], sampler);
}

std::vector<gpu::ImageUse> gbufferUses(const std::vector<gpu::DeviceImage>& gbuffer)
{
    std::vector<gpu::ImageUse> uses;
    for (const gpu::DeviceImage& image : gbuffer)
        uses.push_back(gpu::use(image, gpu::Access::sampled));
    return uses;
}

} // namespace torrance
