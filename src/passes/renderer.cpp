#include "passes/renderer.h"

#include "gpu/guard.h"
#include "image/reconstruction.h"
#include "passes/deferred_pass.h"
#include "passes/frame_data.h"
#include "passes/layers.h"
#include "passes/sampler.h"
#include "passes/targets.h"
#include "scene/camera_view.h"
#include "shaders/shared/bindings.h"

#include <algorithm>
#include <array>
#include <bit>

namespace torrance {
namespace {

template <typename T>
std::span<const std::byte> bytesOf(const std::vector<T>& items)
{
    return std::as_bytes(std::span(items));
}

// What differs from camera to camera, on the device.
struct ViewBuffers
{
    gpu::Buffer frame;
    gpu::Buffer instances;
    gpu::Buffer lights;
};

ViewBuffers makeViewBuffers(const gpu::Device& device, const DeviceScene& scene, const Camera& camera,
                            const dvec2& offset, int picture)
{
    constexpr auto kUsage = vk::BufferUsageFlagBits::eStorageBuffer;
    const auto& environment = scene.environment;
    const int levels = environment.specular ? static_cast<int>(environment.specular->shape.mips) : 0;
    const int panoramaWidth = environment.panorama ? static_cast<int>(environment.panorama->shape.width) : 0;
    shared::Frame frame = makeFrame(scene.scene, scene.plan, camera, offset, levels, panoramaWidth);
    std::ranges::copy(environment.harmonics, frame.irradianceHarmonics);
    frame.picture = static_cast<std::uint32_t>(picture);
    const std::vector frames = {frame};
    const dvec3 eye = cameraPosition(camera);
    return {.frame = gpu::makeBuffer(device, bytesOf(frames), kUsage, "frame"),
            .instances =
                gpu::makeBuffer(device, bytesOf(makeInstances(scene.plan, scene.meshes, eye)), kUsage, "instances"),
            .lights = gpu::makeBuffer(device, bytesOf(makeLights(scene.plan, eye)), kUsage, "lights")};
}

dvec3 forwardOf(const Camera& camera)
{
    const dmat4 view = viewFromWorld(camera);
    return -dvec3(view[0].z, view[1].z, view[2].z);
}

gpu::Bindings sceneBindings(const DeviceScene& scene, const ViewBuffers& view, const vk::raii::Sampler& table,
                            const vk::raii::Sampler& panorama)
{
    gpu::Bindings bindings;
    bindings.set(shared::kBindFrame, view.frame);
    bindings.set(shared::kBindInstances, view.instances);
    bindings.set(shared::kBindLights, view.lights);
    bindings.set(shared::kBindMaterials, scene.materials);
    const EnvironmentImages& environment = scene.environment;
    if (environment.specular)
        bindings.set(shared::kBindEnvironmentSpecular, *environment.specular, table);
    if (environment.diffuse)
        bindings.set(shared::kBindEnvironmentDiffuse, *environment.diffuse, table);
    if (environment.radiance)
        bindings.set(shared::kBindEnvironmentRadiance, *environment.radiance, table);
    if (environment.dfg)
        bindings.set(shared::kBindDfg, *environment.dfg, table);
    if (environment.panorama)
        bindings.set(shared::kBindPanorama, *environment.panorama, panorama);
    return bindings;
}

// Everything of the scene that a frame's shaders read.
void useScene(gpu::Commands& commands, const DeviceScene& scene, const ViewBuffers& view)
{
    std::vector<gpu::ImageUse> images = scene.textures.uses();
    const EnvironmentImages& e = scene.environment;
    for (const gpu::DeviceImage* image : {e.specular, e.diffuse, e.radiance, e.dfg, e.panorama})
        if (image)
            images.push_back(gpu::use(*image, gpu::Access::sampled));
    const std::array buffers = {gpu::use(view.frame, gpu::Access::shaderRead),
                                gpu::use(view.instances, gpu::Access::shaderRead),
                                gpu::use(view.lights, gpu::Access::shaderRead),
                                gpu::use(scene.materials, gpu::Access::shaderRead),
                                gpu::use(scene.meshes.vertices, gpu::Access::vertexRead),
                                gpu::use(scene.meshes.indices, gpu::Access::vertexRead)};
    commands.use(images, buffers);
}

} // namespace

Renderer::Renderer(const gpu::Device& d, gpu::ShaderLibrary& s, const std::filesystem::path& cacheFolder)
    : device(d), shaders(s), environments(d, cacheFolder), tableSampler(makeTableSampler(d)),
      panoramaSampler(makePanoramaSampler(d)), surfacePipelines(d, s)
{
}

DeviceScene Renderer::upload(const Scene& scene, const ShadingPlan& plan)
{
    return gpu::guarded(device, [&] {
        return DeviceScene{.scene = scene,
                           .plan = plan,
                           .meshes = makeMeshBuffers(device, scene, plan),
                           .textures = Textures(device, scene, plan),
                           .environment = environments.get(scene, plan),
                           .materials = gpu::makeBuffer(device, bytesOf(makeMaterials(plan)),
                                                        vk::BufferUsageFlagBits::eStorageBuffer, "materials")};
    });
}

const gpu::Pipeline& Renderer::imagePipeline(const std::string& fragment, const std::string& selected,
                                             const gpu::PipelineDescription& description)
{
    std::string identity = fragment + selected;
    for (const std::uint32_t constant : description.constants)
        identity += " " + std::to_string(constant);
    if (const auto found = imagePipelines.find(identity); found != imagePipelines.end())
        return found->second;
    return imagePipelines
        .emplace(identity, gpu::makePipeline(device, shaders.get("passes/fullscreen.vert", selected),
                                             shaders.get(fragment, selected), description))
        .first->second;
}

void Renderer::drawBackground(gpu::Commands& commands, const DeviceScene& scene, const gpu::Bindings& bindings)
{
    if (scene.plan.settings.background == BackgroundKind::transparent)
        return; // the target was cleared to nothing
    const gpu::Pipeline& pipeline =
        imagePipeline("passes/background.frag", scene.plan.panorama ? "#define PANORAMA\n" : "",
                      {.name = "background",
                       .colorFormats = {kColorFormat},
                       .depthFormat = kDepthFormat,
                       .depth = gpu::DepthUse::untouched});
    commands.buffer.setCullMode(vk::CullModeFlagBits::eNone);
    commands.buffer.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline.handle);
    bindings.push(commands.buffer, pipeline);
    commands.buffer.draw(3, 1, 0, 0);
}

Renderer::Targets Renderer::makeTargets(const Settings& settings)
{
    Targets targets = {.color = makeColorTarget(device, settings.width, settings.height, "color"),
                       .depth = makeDepthTarget(device, settings.width, settings.height),
                       .gbuffer = {}};
    if (settings.path == RenderPath::deferred)
        targets.gbuffer = makeGBuffer(device, settings.width, settings.height);
    return targets;
}

void Renderer::drawBatches(gpu::Commands& commands, const DeviceScene& scene, const gpu::Bindings& bindings,
                           SurfaceOutput output)
{
    for (const Batch& batch : scene.plan.batches)
        drawBatch(commands, surfacePipelines.get(scene.plan, batch.key, output), bindings, batch, scene.meshes,
                  scene.textures);
}

void Renderer::drawGBuffer(gpu::Commands& commands, const DeviceScene& scene, const gpu::Bindings& bindings,
                           const Targets& targets)
{
    std::vector<const gpu::DeviceImage*> pointers;
    for (const gpu::DeviceImage& target : targets.gbuffer)
        pointers.push_back(&target);
    beginRendering(commands, pointers, &targets.depth, LoadTarget::clear, LoadTarget::clear);
    drawBatches(commands, scene, bindings, SurfaceOutput::gbuffer);
    commands.buffer.endRendering();
    commands.use(gbufferUses(targets.gbuffer));
}

void Renderer::drawLighting(gpu::Commands& commands, const DeviceScene& scene, gpu::Bindings bindings,
                            const Targets& targets)
{
    bindGBuffer(bindings, targets.gbuffer, tableSampler);
    for (std::size_t i = 0; i < scene.plan.lightingClasses.size(); ++i) {
        const LightingForm form = lightingForm(scene.plan, i);
        const gpu::Pipeline& pipeline = imagePipeline("passes/lighting.frag", form.selected, form.description);
        commands.buffer.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline.handle);
        bindings.push(commands.buffer, pipeline);
        commands.buffer.draw(3, 1, 0, 0);
    }
}

void Renderer::drawColor(const DeviceScene& scene, const Camera& camera, const dvec2& offset, int picture,
                         const Targets& targets)
{
    const ViewBuffers view = makeViewBuffers(device, scene, camera, offset, picture);
    const gpu::Bindings bindings = sceneBindings(scene, view, tableSampler, panoramaSampler);
    const bool deferred = scene.plan.settings.path == RenderPath::deferred;
    gpu::Commands commands(device);
    useScene(commands, scene, view);
    if (deferred)
        drawGBuffer(commands, scene, bindings, targets);
    const std::array colors = {&targets.color};
    beginRendering(commands, colors, &targets.depth, LoadTarget::clear,
                   deferred ? LoadTarget::keep : LoadTarget::clear);
    if (deferred)
        drawLighting(commands, scene, bindings, targets);
    else
        drawBatches(commands, scene, bindings, SurfaceOutput::color);
    drawBackground(commands, scene, bindings);
    for (const Batch* batch : sortedBlended(scene.plan, cameraPosition(camera), forwardOf(camera)))
        drawBatch(commands, surfacePipelines.get(scene.plan, batch->key, SurfaceOutput::color), bindings, *batch,
                  scene.meshes, scene.textures);
    commands.buffer.endRendering();
    commands.submitAndWait();
}

void Renderer::accumulate(const gpu::DeviceImage& source, const gpu::DeviceImage& sum, int index, int count)
{
    const gpu::Pipeline& pipeline =
        imagePipeline("passes/accumulate.frag", "",
                      {.name = "accumulate",
                       .colorFormats = {kColorFormat},
                       .blend = gpu::Blend::add,
                       .constants = {std::bit_cast<std::uint32_t>(1.0f / static_cast<float>(count))}});
    gpu::Bindings bindings;
    bindings.set(shared::kBindSource, source, tableSampler);
    gpu::Commands commands(device);
    commands.use({gpu::use(source, gpu::Access::sampled)});
    const std::array targets = {&sum};
    beginRendering(commands, targets, nullptr, index == 0 ? LoadTarget::clear : LoadTarget::keep, LoadTarget::clear);
    commands.buffer.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline.handle);
    bindings.push(commands.buffer, pipeline);
    commands.buffer.draw(3, 1, 0, 0);
    commands.buffer.endRendering();
    commands.submitAndWait();
}

std::vector<Layer> Renderer::drawLayers(const DeviceScene& scene, const Camera& camera, const gpu::DeviceImage& depth)
{
    const ViewBuffers view = makeViewBuffers(device, scene, camera, dvec2(0.0), 0);
    const gpu::Bindings bindings = sceneBindings(scene, view, tableSampler, panoramaSampler);
    std::vector<gpu::DeviceImage> targets;
    std::vector<const gpu::DeviceImage*> targetPointers;
    for (std::size_t i = 0; i < kLayerTargets; ++i)
        targets.push_back(makeColorTarget(device, scene.plan.settings.width, scene.plan.settings.height, "layers"));
    for (const gpu::DeviceImage& target : targets)
        targetPointers.push_back(&target);

    gpu::Commands commands(device);
    useScene(commands, scene, view);
    beginRendering(commands, targetPointers, &depth, LoadTarget::clear, LoadTarget::clear);
    for (const auto* list : {&scene.plan.batches, &scene.plan.blended})
        for (const Batch& batch : *list) {
            const gpu::Pipeline& pipeline = surfacePipelines.get(scene.plan, batch.key, SurfaceOutput::layers);
            drawBatch(commands, pipeline, bindings, batch, scene.meshes, scene.textures);
        }
    commands.buffer.endRendering();
    commands.submitAndWait();

    std::vector<Image> images;
    for (const gpu::DeviceImage& target : targets)
        images.push_back(readBack(device, target));
    return splitLayers(images, cameraPosition(camera));
}

Picture Renderer::render(const DeviceScene& scene, const Camera& camera, const std::function<void(int, int)>& progress)
{
    return gpu::guarded(device, [&] {
        const Settings& settings = scene.plan.settings;
        const Targets targets = makeTargets(settings);
        const std::vector<dvec2> offsets = sampleOffsets(settings.samples);
        const int count = static_cast<int>(offsets.size());
        std::optional<gpu::DeviceImage> sum;
        if (count > 1)
            sum = makeColorTarget(device, settings.width, settings.height, "sum of samples");
        for (int i = 0; i < count; ++i) {
            drawColor(scene, camera, offsets[static_cast<std::size_t>(i)], i, targets);
            if (sum)
                accumulate(targets.color, *sum, i, count);
            if (progress)
                progress(i + 1, count);
        }
        Picture picture = {.color = readBack(device, sum ? *sum : targets.color), .layers = {}};
        if (settings.layers)
            picture.layers = drawLayers(scene, camera, targets.depth);
        return picture;
    });
}

} // namespace torrance
