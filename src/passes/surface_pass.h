// Draws a plan's surfaces: their colour, or their parameters as layers or as a G-buffer.
#pragma once

#include "gpu/commands.h"
#include "gpu/pipeline.h"
#include "gpu/shader_library.h"
#include "passes/frame_inputs.h"

#include <map>
#include <string>
#include <utility>

namespace torrance {

enum class SurfaceOutput
{
    color,        // one target
    depth,        // none, and only of surfaces that hasDepthPass
    sampleDepth,  // as depth, of four samples a pixel
    colorAtDepth, // as color, where SurfaceOutput::depth has drawn
    layers,       // kLayerTargets targets: shaders/passes/surface_layers.frag
    attributes,   // one or two: shaders/material/attributes.glsl
    gbuffer,      // kGBufferTargets targets: shaders/passes/gbuffer.frag
};
inline constexpr std::size_t kLayerTargets = 6;
inline constexpr std::size_t kGBufferTargets = 4;

vk::PrimitiveTopology topologyOf(SurfaceKind kind);

/// Binds the textures of a set, by role.
void bindTextures(gpu::Bindings& bindings, const TextureSet& set, const Textures& textures);

/// Specialization constants, from 0 on, of every shader that includes material/shade.glsl: the numbers of lights, of
/// samples.
std::vector<std::uint32_t> shadingConstants(const ShadingPlan& plan, const ShaderKey& key);

/// What selected.glsl says beside the plan: whether shading's vertex shaders tell fragments what these read of uniform
/// blocks (shaders/passes/flat_uniforms.glsl), as pays off where a processor draws.
const char* flatUniformsText(const gpu::Device& device);

/// Whether depth can be drawn before colour: not of analytic shapes, whose depth is computed for each pixel, and twice
/// need not give the same bits.
bool hasDepthPass(const ShaderKey& key);

/// The pipelines of a plan's keys, made on first use.
class SurfacePipelines
{
public:
    SurfacePipelines(const gpu::Device& d, gpu::ShaderLibrary& s) : device(d), shaders(s) {}

    const gpu::Pipeline& get(const ShadingPlan& plan, const Batch& batch, SurfaceOutput output);
    std::size_t count() const { return pipelines.size(); }

    using Map = std::map<std::string, gpu::Pipeline>; // by everything that they are made from
    /// Puts others in the place of those that were made so far.
    Map exchange(Map others) { return std::exchange(pipelines, std::move(others)); }

private:
    const gpu::Device& device;
    gpu::ShaderLibrary& shaders;
    Map pipelines;
};

/// Records the draws of one batch inside a rendering, `pipeline` being that of its key and `output`.
void drawBatch(gpu::Commands& commands, const gpu::Pipeline& pipeline, const Batch& batch, SurfaceOutput output,
               const FrameInputs& frame);

/// The blended batches from back to front: by the distance of their bounds' centres along the axis of view.
std::vector<const Batch*> sortedBlended(const ShadingPlan& plan, const dvec3& eye, const dvec3& forward);

} // namespace torrance
