// A planned scene and a camera in, pictures out.
#pragma once

#include "gpu/device.h"
#include "gpu/shader_library.h"
#include "image/image.h"
#include "passes/attribute_pass.h"
#include "passes/device_scene.h"
#include "passes/edge_pass.h"
#include "passes/frame_inputs.h"
#include "passes/surface_pass.h"
#include "passes/target_fill.h"
#include "passes/triangle_culling.h"
#include "plan/shading_plan.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace torrance {

/// A named picture beside the colour: "depth", "normal", ... with the names of its channels.
struct Layer
{
    std::string name;
    std::vector<std::string> channels; // "X", "Y", "Z" or "R", "G", "B", or "V" for a scalar
    Image image;
};

/// The names that layers can have, in their order.
std::vector<std::string> layerNames();

struct Picture
{
    Image color;               // RGBA, scene-linear, premultiplied by alpha
    std::vector<Layer> layers; // asked for by Settings::layers; at the pixels' centres, not filtered
};

/// Runs one pass of a frame by calling `run`, which records it, submits it and waits: to be timed by itself.
using PassObserver = std::function<void(const char* pass, const std::function<void()>& run)>;

class Renderer
{
public:
    /// `cacheFolder` keeps prefiltered environments; empty: none are kept.
    Renderer(const gpu::Device& device, gpu::ShaderLibrary& shaders, const std::filesystem::path& cacheFolder);

    /// To be drawn from any camera, or, where one is given, from that one only: levels of textures that its picture
    /// cannot read are left out (plan/level_plan.h). The scene's texels are not read afterwards, nor those of an image
    /// after `texelsRead` was called with it: whoever owns the scene may free them then. Throws TexelsMissing where
    /// pictures have no texels and `kept` has not all levels that are asked for.
    DeviceScene upload(const Scene& scene, const ShadingPlan& plan, const Camera* onlyCamera = nullptr,
                       const TexelsRead& texelsRead = {}, const KeptLevels& kept = {});

    /// Another plan of the same scene, whose materials, lights, environment and settings may have changed since; meshes
    /// and textures are uploaded again only where the plan changes them. `old` was uploaded for any camera.
    DeviceScene replan(const DeviceScene& old, const ShadingPlan& plan);

    /// Makes what the plan reads of the scene's environment, so that the scene is uploaded without waiting for it. May
    /// run beside everything else.
    void prepareEnvironment(const Scene& scene, const ShadingPlan& plan);

    /// `progress` is called with (done, all) samples after each. With `only`, boxes within the picture, surfaces are
    /// drawn there alone, without layers, and what the colour is elsewhere is not said: boxes of whole blocks
    /// (pixel_box.h) hold what the whole picture holds there. Throws Error (deviceFailure, usage).
    Picture render(const DeviceScene& scene, const Camera& camera, const std::function<void(int, int)>& progress = {},
                   std::span<const PixelBox> only = {});

    /// The picture of one sample at the pixels' centres, or of one shading a pixel, left on the device: what a frame of
    /// a window costs. With an observer each pass is submitted apart, else all at once. Throws as render().
    void drawFrame(const DeviceScene& scene, const Camera& camera, const PassObserver& observer = {});

    /// What drawFrame left: RGBA, scene-linear, premultiplied. Valid until a frame of another size is drawn.
    const gpu::DeviceImage& frame(const ShadingPlan& plan) const;

    /// Pipelines as they were made so far. Without them, drawing makes them anew, from the shaders as they are then.
    struct Pipelines
    {
        SurfacePipelines::Map surfaces, images;
    };
    Pipelines exchangePipelines(Pipelines others);

    std::size_t pipelineCount() const { return surfacePipelines.count() + imagePipelines.size(); }

private:
    // What frames are drawn into, kept from one to the next: a software driver's new memory costs a page fault each 4
    // KiB.
    struct Targets
    {
        int width = 0;
        int height = 0;
        gpu::DeviceImage color;
        std::optional<gpu::DeviceImage> depth;
        std::optional<EdgeTargets> edges;           // where pixels are shaded once
        std::vector<gpu::DeviceImage> gbuffer;      // of the deferred path
        std::optional<AttributeTargets> attributes; // of the attributes path
    };
    // A part of a frame that begins and ends its own rendering.
    struct Pass
    {
        const char* name;
        std::function<void(gpu::Commands&)> record;
    };
    void requireSampling(const ShadingPlan& plan) const;
    DeviceScene assemble(const Scene& scene, const ShadingPlan& plan, std::span<const int> finest,
                         std::shared_ptr<const MeshBuffers> meshes, std::shared_ptr<const Textures> textures);
    void prepareTargets(const ShadingPlan& plan);
    FrameInputs inputsOf(const DeviceScene& scene, const Camera& camera, const dvec2& offset, int picture);
    void drawColor(const DeviceScene& scene, const Camera& camera, const dvec2& offset, int picture,
                   const PassObserver& observer, std::span<const PixelBox> only);
    void run(const std::vector<Pass>& passes, const FrameInputs& frame, const PassObserver& observer);
    // beginRendering, with colours filled as the device does it best.
    void begin(gpu::Commands& commands, std::span<const gpu::DeviceImage* const> colors, const gpu::DeviceImage* depth,
               const ClearColor& clearColor, LoadTarget loadDepth);
    void drawBatches(gpu::Commands& commands, const FrameInputs& frame, SurfaceOutput output);
    void drawOne(gpu::Commands& commands, const FrameInputs& frame, const Batch& batch, SurfaceOutput output);
    void drawDepth(gpu::Commands& commands, const FrameInputs& frame);
    void drawAttributes(gpu::Commands& commands, const FrameInputs& frame);
    void resolveAttributes(gpu::Commands& commands, const FrameInputs& frame);
    void drawDirectly(gpu::Commands& commands, const FrameInputs& frame);
    void drawBlended(gpu::Commands& commands, const FrameInputs& frame);
    void drawGBuffer(gpu::Commands& commands, const FrameInputs& frame);
    void drawLighting(gpu::Commands& commands, const FrameInputs& frame);
    void drawSurfaces(gpu::Commands& commands, const FrameInputs& frame);
    void drawBackground(gpu::Commands& commands, const FrameInputs& frame);
    void drawSampleDepth(gpu::Commands& commands, const FrameInputs& frame);
    void reconstruct(gpu::Commands& commands, const FrameInputs& frame);
    void accumulate(const gpu::DeviceImage& sum, int index, int count);
    std::vector<Layer> drawLayers(const DeviceScene& scene, const Camera& camera);
    const gpu::Pipeline& imagePipeline(const std::string& fragment, const std::string& selected,
                                       const gpu::PipelineDescription& description,
                                       const std::string& vertex = "passes/fullscreen.vert");

    const gpu::Device& device;
    gpu::ShaderLibrary& shaders;
    EnvironmentStore environments;
    vk::raii::Sampler tableSampler;
    vk::raii::Sampler pointSampler;
    vk::raii::Sampler panoramaSampler;
    SurfacePipelines surfacePipelines;
    std::map<std::string, gpu::Pipeline> imagePipelines;
    Targets targets;
    TargetFill targetFill;
    TriangleCulling culling;
};

} // namespace torrance
