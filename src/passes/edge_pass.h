// One shading a pixel, four samples of depth: the pixels that hold an edge, and their means (brdf/pixel_sampling.h).
#pragma once

#include "gpu/commands.h"
#include "gpu/pipeline.h"
#include "passes/frame_inputs.h"
#include "scene/pixel_box.h"

namespace torrance {

struct EdgeTargets
{
    gpu::DeviceImage sampleDepth; // four samples a pixel
    gpu::DeviceImage edges;       // depth: 0 where the samples lie on more than one surface
    gpu::DeviceImage result;
};

EdgeTargets makeEdgeTargets(const gpu::Device& device, int width, int height);

/// The pipelines that mark edges and that work on them.
gpu::PipelineDescription edgesDescription();
gpu::PipelineDescription reconstructionDescription();

/// What both read: colour and depth of one sample at the pixels' centres, and the samples' depths.
gpu::Bindings edgeBindings(const FrameInputs& frame, const gpu::DeviceImage& color, const gpu::DeviceImage& depth,
                           const EdgeTargets& targets, const vk::raii::Sampler& sampler);

/// The part of the picture where opaque surfaces may be seen.
PixelBox surfaceArea(const FrameInputs& frame);

} // namespace torrance
