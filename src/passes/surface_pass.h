// Draws a plan's surfaces: their colour, or their parameters as layers or as a G-buffer.
#pragma once

#include "gpu/commands.h"
#include "gpu/pipeline.h"
#include "gpu/shader_library.h"
#include "passes/mesh_buffers.h"
#include "passes/texture_upload.h"
#include "plan/shading_plan.h"

#include <map>
#include <string>

namespace torrance {

enum class SurfaceOutput
{
    color,   // one target
    layers,  // kLayerTargets targets: shaders/passes/surface_layers.frag
    gbuffer, // kGBufferTargets targets: shaders/passes/gbuffer.frag
};
inline constexpr std::size_t kLayerTargets = 6;
inline constexpr std::size_t kGBufferTargets = 4;

/// Specialization constants, from 0 on, of every shader that includes material/shade.glsl: the numbers of lights, of
/// samples.
std::vector<std::uint32_t> shadingConstants(const ShadingPlan& plan);

/// The pipelines of a plan's keys, made on first use.
class SurfacePipelines
{
public:
    SurfacePipelines(const gpu::Device& d, gpu::ShaderLibrary& s) : device(d), shaders(s) {}

    const gpu::Pipeline& get(const ShadingPlan& plan, const ShaderKey& key, SurfaceOutput output);
    std::size_t count() const { return pipelines.size(); }

private:
    const gpu::Device& device;
    gpu::ShaderLibrary& shaders;
    std::map<std::string, gpu::Pipeline> pipelines; // by everything that they are made from
};

/// Records the draws of one batch inside a rendering; `bindings` holds all but the batch's textures.
void drawBatch(gpu::Commands& commands, const gpu::Pipeline& pipeline, gpu::Bindings bindings, const Batch& batch,
               const MeshBuffers& meshes, const Textures& textures);

/// The blended batches from back to front: by the distance of their bounds' centres along the axis of view.
std::vector<const Batch*> sortedBlended(const ShadingPlan& plan, const dvec3& eye, const dvec3& forward);

} // namespace torrance
