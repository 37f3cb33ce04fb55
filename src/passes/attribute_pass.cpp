#include "passes/attribute_pass.h"

#include "passes/targets.h"
#include "plan/attribute_plan.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/material.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace torrance {

static_assert(kMaxClassMaterials == shared::kMaxClassMaterials);

AttributeTargets makeAttributeTargets(const gpu::Device& device, int width, int height, std::size_t pictures)
{
    using Usage = vk::ImageUsageFlagBits;
    AttributeTargets targets;
    for (std::size_t i = 0; i < pictures; ++i)
        targets.pictures.push_back(gpu::makeImage(device,
                                                  {.width = static_cast<std::uint32_t>(width),
                                                   .height = static_cast<std::uint32_t>(height),
                                                   .format = kAttributeFormat},
                                                  Usage::eColorAttachment | Usage::eSampled | Usage::eTransferDst,
                                                  "attributes"));
    targets.depth = makeDepthStencilTarget(device, width, height);
    return targets;
}

struct ClassBlock
{
    std::array<shared::Material, kMaxClassMaterials> materials;
};

gpu::UniformBlocks makeClassBlocks(const gpu::Device& device, const ShadingPlan& plan,
                                   std::span<const shared::Material> materials)
{
    std::vector<ClassBlock> blocks;
    for (const ShadingClass& shadingClass : plan.classes) {
        if (shadingClass.blocks.size() < 2)
            continue; // bound by itself
        ClassBlock& block = blocks.emplace_back();
        for (std::size_t slot = 0; slot < shadingClass.blocks.size(); ++slot)
            block.materials[slot] = materials[static_cast<std::size_t>(shadingClass.blocks[slot])];
    }
    return gpu::makeUniformBlocks<ClassBlock>(device, shared::kBindMaterial, blocks, "materials of classes");
}

ResolveForm resolveForm(const ShadingPlan& plan, const ShadingClass& shadingClass)
{
    return {.selected = resolveText(plan, shadingClass),
            .description = {.name = "shading of " + shadingClass.key.name(),
                            .colorFormats = {kColorFormat},
                            .depthFormat = kDepthStencilFormat,
                            .stencil = gpu::StencilUse::equal,
                            .constants = shadingConstants(plan, shadingClass.key)}};
}

gpu::Bindings resolveBindings(const FrameInputs& frame, std::size_t index, const AttributeTargets& targets,
                              const vk::raii::Sampler& sampler)
{
    const ShadingPlan& plan = frame.scene.plan;
    const ShadingClass& shadingClass = plan.classes[index];
    gpu::Bindings bindings = frame.bindingsOf(shadingClass.key);
    bindTextures(bindings, shadingClass.textures, *frame.scene.textures);
    if (shadingClass.blocks.size() < 2)
        frame.scene.materials.bind(bindings, static_cast<std::size_t>(shadingClass.blocks.front()));
    else
        frame.scene.classMaterials.bind(
            bindings,
            static_cast<std::size_t>(std::count_if(plan.classes.begin(), plan.classes.begin() + std::ptrdiff_t(index),
                                                   [](const ShadingClass& c) { return c.blocks.size() > 1; })));
    for (std::size_t i = 0; i < targets.pictures.size(); ++i)
        bindings.set(shared::kBindAttributes + static_cast<std::uint32_t>(i), targets.pictures[i], sampler);
    bindings.set(shared::kBindDepth, targets.depth, sampler);
    return bindings;
}

std::vector<PixelBox> classAreas(const FrameInputs& frame)
{
    const ShadingPlan& plan = frame.scene.plan;
    std::vector<PixelBox> areas(plan.classes.size());
    for (const Batch& batch : plan.batches)
        for (const Draw& draw : batch.draws)
            if (batch.shadingClass >= 0)
                areas[static_cast<std::size_t>(batch.shadingClass)].include(
                    pixelBoxOf(frame.camera, plan.settings.width, plan.settings.height, draw.bounds));
    return areas;
}

std::vector<gpu::ImageUse> attributeUses(const AttributeTargets& targets)
{
    std::vector<gpu::ImageUse> uses;
    for (const gpu::DeviceImage& picture : targets.pictures)
        uses.push_back(gpu::use(picture, gpu::Access::sampled));
    return uses;
}

} // namespace torrance
