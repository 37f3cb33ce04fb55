// A planned scene and a camera in, pictures out.
#pragma once

#include "gpu/device.h"
#include "gpu/shader_library.h"
#include "image/image.h"
#include "passes/environment_upload.h"
#include "passes/mesh_buffers.h"
#include "passes/surface_pass.h"
#include "passes/texture_upload.h"
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

/// A scene on a device, ready to be drawn from any camera. Scene, plan and renderer must outlive it.
struct DeviceScene
{
    const Scene& scene;
    const ShadingPlan& plan;
    MeshBuffers meshes;
    Textures textures;
    EnvironmentImages environment;
    gpu::Buffer materials;
};

class Renderer
{
public:
    /// `cacheFolder` keeps prefiltered environments; empty: none are kept.
    Renderer(const gpu::Device& device, gpu::ShaderLibrary& shaders, const std::filesystem::path& cacheFolder);

    DeviceScene upload(const Scene& scene, const ShadingPlan& plan);

    /// `progress` is called with (done, all) samples after each. Throws Error (deviceFailure, usage).
    Picture render(const DeviceScene& scene, const Camera& camera, const std::function<void(int, int)>& progress = {});

    std::size_t pipelineCount() const { return surfacePipelines.count() + imagePipelines.size(); }

private:
    struct Targets
    {
        gpu::DeviceImage color;
        gpu::DeviceImage depth;
        std::vector<gpu::DeviceImage> gbuffer; // of the deferred path
    };
    Targets makeTargets(const Settings& settings);
    void drawColor(const DeviceScene& scene, const Camera& camera, const dvec2& offset, int picture,
                   const Targets& targets);
    void drawBatches(gpu::Commands& commands, const DeviceScene& scene, const gpu::Bindings& bindings,
                     SurfaceOutput output);
    void drawGBuffer(gpu::Commands& commands, const DeviceScene& scene, const gpu::Bindings& bindings,
                     const Targets& targets);
    void drawLighting(gpu::Commands& commands, const DeviceScene& scene, gpu::Bindings bindings,
                      const Targets& targets);
    void drawBackground(gpu::Commands& commands, const DeviceScene& scene, const gpu::Bindings& bindings);
    void accumulate(const gpu::DeviceImage& source, const gpu::DeviceImage& sum, int index, int count);
    std::vector<Layer> drawLayers(const DeviceScene& scene, const Camera& camera, const gpu::DeviceImage& depth);
    const gpu::Pipeline& imagePipeline(const std::string& fragment, const std::string& selected,
                                       const gpu::PipelineDescription& description);

    const gpu::Device& device;
    gpu::ShaderLibrary& shaders;
    EnvironmentStore environments;
    vk::raii::Sampler tableSampler;
    vk::raii::Sampler panoramaSampler;
    SurfacePipelines surfacePipelines;
    std::map<std::string, gpu::Pipeline> imagePipelines;
};

} // namespace torrance
