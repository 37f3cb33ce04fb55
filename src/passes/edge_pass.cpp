#include "passes/edge_pass.h"

#include "passes/targets.h"
#include "shaders/shared/bindings.h"

namespace torrance {

EdgeTargets makeEdgeTargets(const gpu::Device& device, int width, int height)
{
    return {.sampleDepth = makeSampleDepthTarget(device, width, height),
            .edges = makeDepthTarget(device, width, height, "edges"),
            .result = makeColorTarget(device, width, height, "reconstructed")};
}

gpu::PipelineDescription edgesDescription()
{
    return {.name = "edges", .depthFormat = kDepthFormat, .depth = gpu::DepthUse::testAndWrite};
}

gpu::PipelineDescription reconstructionDescription()
{
    return {.name = "reconstruction",
            .colorFormats = {kColorFormat},
            .depthFormat = kDepthFormat,
            .depth = gpu::DepthUse::equal}; // where edges.frag wrote 0
}

gpu::Bindings edgeBindings(const FrameInputs& frame, const gpu::DeviceImage& color, const gpu::DeviceImage& depth,
                           const EdgeTargets& targets, const vk::raii::Sampler& sampler)
{
    gpu::Bindings bindings = frame.common();
    bindings.set(shared::kBindSource, color, sampler);
    bindings.set(shared::kBindDepth, depth, sampler);
    bindings.set(shared::kBindSampleDepth, targets.sampleDepth, sampler);
    return bindings;
}

PixelBox surfaceArea(const FrameInputs& frame)
{
    const Settings& settings = frame.scene.plan.settings;
    PixelBox area;
    for (const Batch& batch : frame.scene.plan.batches)
        for (const Draw& draw : batch.draws)
            area.include(pixelBoxOf(frame.camera, settings.width, settings.height, draw.bounds));
    return area;
}

} // namespace torrance
