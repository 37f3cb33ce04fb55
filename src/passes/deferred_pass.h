// The deferred path: surfaces leave their parameters in a G-buffer, then one pass over the picture for each lighting
// class.
#pragma once

#include "gpu/commands.h"
#include "gpu/pipeline.h"
#include "passes/surface_pass.h"

#include <vector>

namespace torrance {

/// kGBufferTargets pictures of 32-bit floats: shaders/passes/gbuffer.frag says what is in them.
std::vector<gpu::DeviceImage> makeGBuffer(const gpu::Device& device, int width, int height);

/// A lighting pipeline: what it is made from.
struct LightingForm
{
    std::string selected; // text of selected.glsl
    gpu::PipelineDescription description;
};
LightingForm lightingForm(const ShadingPlan& plan, std::size_t lightingClass);

/// The G-buffer as the lighting pass reads it, texel by texel: the sampler's filter has no effect.
void bindGBuffer(gpu::Bindings& bindings, const std::vector<gpu::DeviceImage>& gbuffer,
                 const vk::raii::Sampler& sampler);
std::vector<gpu::ImageUse> gbufferUses(const std::vector<gpu::DeviceImage>& gbuffer); // as sampled

} // namespace torrance
