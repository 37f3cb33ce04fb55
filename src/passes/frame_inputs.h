// What the passes of one frame read: the scene, and what differs from camera to camera and from sample to sample.
#pragma once

#include "gpu/commands.h"
#include "passes/device_scene.h"
#include "passes/triangle_culling.h"

#include <span>
#include <vector>

namespace torrance {

struct FrameInputs
{
    const DeviceScene& scene;
    const Camera& camera;
    /// By ShadingPlan::choices, with kMaxLights lights behind each, whatever their number: so large is the shaders'
    /// block.
    std::vector<gpu::Buffer> frames;
    gpu::Buffer instances;                     // shared::Instance by ShadingPlan::instances, a vertex shader's
    gpu::UniformBlocks shapeInstances;         // the same, where there are analytic shapes
    std::vector<gpu::Bindings> bindings;       // by ShadingPlan::choices: all but those that change from draw to draw
    const VisibleTriangles* visible = nullptr; // the culling's; null: all triangles are drawn
    std::span<const PixelBox> only = {};       // surfaces are drawn in these boxes alone; none: everywhere

    /// Of surfaces of this key, and of what is no surface.
    const gpu::Bindings& bindingsOf(const ShaderKey& key) const
    {
        return bindings[static_cast<std::size_t>(key.choice)];
    }
    const gpu::Bindings& common() const { return bindings.front(); }
};

/// How the environment's pictures are read.
struct FrameSamplers
{
    const vk::raii::Sampler& table;
    const vk::raii::Sampler& panorama;
};

/// For a sample `offset` pixels from the pixels' centres, of the picture of this number among those whose mean is the
/// result. The culling's triangles are those of this frame until it is asked for another's.
FrameInputs makeFrameInputs(const gpu::Device& device, const DeviceScene& scene, const Camera& camera,
                            const FrameSamplers& samplers, const dvec2& offset, int picture, TriangleCulling& culling);

/// Notes the use of everything that a frame's shaders read.
void useFrame(gpu::Commands& commands, const FrameInputs& frame);

} // namespace torrance
