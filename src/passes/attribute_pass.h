// The attributes path: surfaces leave what was interpolated over them, then each pixel is shaded once, class by class.
#pragma once

#include "gpu/commands.h"
#include "gpu/pipeline.h"
#include "passes/frame_inputs.h"
#include "passes/surface_pass.h"
#include "scene/pixel_box.h"
#include "shaders/shared/material.h"

#include <span>
#include <vector>

namespace torrance {

struct AttributeTargets
{
    std::vector<gpu::DeviceImage> pictures; // one or two: shaders/material/attributes.glsl
    gpu::DeviceImage depth;                 // with the number of the class, + 1, as stencil
};

/// `pictures` is 1 or 2.
AttributeTargets makeAttributeTargets(const gpu::Device& device, int width, int height, std::size_t pictures);

/// Blocks of the classes with several materials: kMaxClassMaterials each.
gpu::UniformBlocks makeClassBlocks(const gpu::Device& device, const ShadingPlan& plan,
                                   std::span<const shared::Material> materials);

/// The pipeline that shades a class: what it is made from.
struct ResolveForm
{
    std::string selected; // text of selected.glsl
    gpu::PipelineDescription description;
};
ResolveForm resolveForm(const ShadingPlan& plan, const ShadingClass& shadingClass);

/// Everything that the pipeline of class number `index` binds.
gpu::Bindings resolveBindings(const FrameInputs& frame, std::size_t index, const AttributeTargets& targets,
                              const vk::raii::Sampler& sampler);

/// By class, the part of the picture where its surfaces may be seen.
std::vector<PixelBox> classAreas(const FrameInputs& frame);

/// The attributes as resolve.frag reads them.
std::vector<gpu::ImageUse> attributeUses(const AttributeTargets& targets);

} // namespace torrance
