#include "passes/renderer.h"

#include "core/error.h"
#include "gpu/guard.h"
#include "image/reconstruction.h"
#include "passes/attribute_pass.h"
#include "passes/deferred_pass.h"
#include "passes/frame_data.h"
#include "passes/frame_inputs.h"
#include "passes/fullscreen.h"
#include "passes/layers.h"
#include "passes/sampler.h"
#include "passes/targets.h"
#include "plan/attribute_plan.h"
#include "plan/level_plan.h"
#include "plan/pixel_sampling_plan.h"
#include "scene/camera_view.h"
#include "shaders/shared/bindings.h"

#include <algorithm>
#include <array>
#include <utility>

namespace torrance {
namespace {

// What stands behind the scene. A panorama is drawn where no surface is, so that nothing is left of what was there.
ClearColor backgroundClear(const ShadingPlan& plan)
{
    const Settings& settings = plan.settings;
    if (plan.panorama)
        return kKeep;
    if (settings.background == BackgroundKind::transparent)
        return kClearToNothing;
    const dvec3 color = settings.background == BackgroundKind::color ? settings.backgroundColor : dvec3(0.0);
    return vec4(vec3(color), 1.0f); // of an environment that is not there: black
}

vk::Rect2D rectangleOf(const PixelBox& box)
{
    const ivec2 size = box.beyond - box.first;
    return {{box.first.x, box.first.y}, {static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y)}};
}

// In a rendering whose depth was cleared: everywhere but in a frame's boxes it is as near as can be, and hides what is
// drawn.
void hideOthers(gpu::Commands& commands, const FrameInputs& frame)
{
    if (frame.only.empty())
        return;
    const Settings& settings = frame.scene.plan.settings;
    const auto clear = [&](float depth, std::span<const PixelBox> boxes) {
        std::vector<vk::ClearRect> rectangles;
        for (const PixelBox& box : boxes)
            rectangles.push_back({.rect = rectangleOf(box), .baseArrayLayer = 0, .layerCount = 1});
        const vk::ClearAttachment attachment = {.aspectMask = vk::ImageAspectFlagBits::eDepth,
                                                .clearValue = vk::ClearDepthStencilValue{depth, 0}};
        commands.buffer.clearAttachments(attachment, rectangles);
    };
    const PixelBox whole = {.beyond = {settings.width, settings.height}};
    clear(1.0f, std::span(&whole, 1));
    clear(0.0f, frame.only);
}

// Pixels that no surface covers are never shaded; but lavapipe shades them in the lanes beside a silhouette's, and what
// lay there was seen to change the last bit of its neighbours: the same inputs give the same bytes only when it is
// always the same.
constexpr ClearColor kClearAttributes = kClearToNothing;

// Whether the attributes path leaves something to be shaded as it is drawn.
bool drawsDirectly(const ShadingPlan& plan)
{
    return !plan.blended.empty() ||
           std::ranges::any_of(plan.batches, [](const Batch& batch) { return batch.shadingClass < 0; });
}

dvec3 forwardOf(const Camera& camera)
{
    const dmat4 view = viewFromWorld(camera);
    return -dvec3(view[0].z, view[1].z, view[2].z);
}

} // namespace

Renderer::Renderer(const gpu::Device& d, gpu::ShaderLibrary& s, const std::filesystem::path& cacheFolder)
    : device(d), shaders(s), environments(d, cacheFolder), tableSampler(makeTableSampler(d)),
      pointSampler(makePointSampler(d)), panoramaSampler(makePanoramaSampler(d)), surfacePipelines(d, s), targetFill(d),
      culling(d)
{
}

void Renderer::requireSampling(const ShadingPlan& plan) const
{
    if (shadesOncePerPixel(plan.settings) && !device.samplesDepth())
        throw usageError(device.description.name + " draws no depth of four samples at the standard places",
                         "use --pixel-sampling supersampled");
}

DeviceScene Renderer::assemble(const Scene& scene, const ShadingPlan& plan, std::span<const int> finest,
                               std::shared_ptr<const MeshBuffers> meshes, std::shared_ptr<const Textures> textures)
{
    const std::vector<shared::Material> materials = makeMaterials(plan, finest);
    return DeviceScene{.scene = scene,
                       .plan = plan,
                       .meshes = std::move(meshes),
                       .textures = std::move(textures),
                       .environments = environments.get(scene, plan),
                       .materials =
                           gpu::makeUniformBlocks(device, shared::kBindMaterial, std::span(materials), "materials"),
                       .classMaterials = makeClassBlocks(device, plan, materials)};
}

DeviceScene Renderer::upload(const Scene& scene, const ShadingPlan& plan, const Camera* onlyCamera,
                             const TexelsRead& texelsRead, const KeptLevels& kept)
{
    requireSampling(plan);
    return gpu::guarded(device, [&] {
        const std::vector<int> finest =
            onlyCamera ? finestLevels(scene, plan, *onlyCamera) : std::vector<int>(plan.textures.size(), 0);
        return assemble(scene, plan, finest, std::make_shared<MeshBuffers>(makeMeshBuffers(device, scene, plan)),
                        std::make_shared<Textures>(device, scene, plan, finest, texelsRead, kept));
    });
}

DeviceScene Renderer::replan(const DeviceScene& old, const ShadingPlan& plan)
{
    requireSampling(plan);
    return gpu::guarded(device, [&] {
        const Scene& scene = old.scene;
        const std::vector<int> finest(plan.textures.size(), 0);
        const bool sameMeshes = makesSameBuffers(scene, old.plan, plan);
        const bool sameTextures = makesSameTextures(old.plan, plan);
        return assemble(scene, plan, finest,
                        sameMeshes ? old.meshes : std::make_shared<MeshBuffers>(makeMeshBuffers(device, scene, plan)),
                        sameTextures ? old.textures : std::make_shared<Textures>(device, scene, plan, finest));
    });
}

void Renderer::prepareEnvironment(const Scene& scene, const ShadingPlan& plan)
{
    gpu::guarded(device, [&] { environments.get(scene, plan); });
}

const gpu::Pipeline& Renderer::imagePipeline(const std::string& fragment, const std::string& selected,
                                             const gpu::PipelineDescription& description, const std::string& vertex)
{
    std::string identity =
        fragment + selected + vk::to_string(description.depthFormat.value_or(vk::Format::eUndefined));
    for (const std::uint32_t constant : description.constants)
        identity += " " + std::to_string(constant);
    if (const auto found = imagePipelines.find(identity); found != imagePipelines.end())
        return found->second;
    return imagePipelines
        .emplace(identity,
                 gpu::makePipeline(device, shaders.get(vertex, selected), shaders.get(fragment, selected), description))
        .first->second;
}

void Renderer::drawBackground(gpu::Commands& commands, const FrameInputs& frame)
{
    if (!frame.scene.plan.panorama)
        return; // the target was cleared to it
    const bool attributes = frame.scene.plan.path == RenderPath::attributes;
    const gpu::Pipeline& pipeline =
        imagePipeline("passes/background.frag", frame.scene.environments.front().background ? "#define BLURRED\n" : "",
                      {.name = "background",
                       .colorFormats = {kColorFormat},
                       .depthFormat = attributes ? kDepthStencilFormat : kDepthFormat,
                       .depth = gpu::DepthUse::equal});
    drawFullscreen(commands, pipeline, frame.common());
}

FrameInputs Renderer::inputsOf(const DeviceScene& scene, const Camera& camera, const dvec2& offset, int picture)
{
    return makeFrameInputs(device, scene, camera, {.table = tableSampler, .panorama = panoramaSampler}, offset, picture,
                           culling);
}

void Renderer::prepareTargets(const ShadingPlan& plan)
{
    const Settings& settings = plan.settings;
    const std::size_t pictures = attributePictures(plan);
    if (targets.width != settings.width || targets.height != settings.height) {
        targets = {}; // the old ones go before the new ones come
        targets.width = settings.width;
        targets.height = settings.height;
        targets.color = makeColorTarget(device, settings.width, settings.height, "color");
    }
    if (shadesOncePerPixel(settings) && !targets.edges)
        targets.edges = makeEdgeTargets(device, settings.width, settings.height);
    const bool attributes = plan.path == RenderPath::attributes;
    if (plan.path == RenderPath::deferred && targets.gbuffer.empty())
        targets.gbuffer = makeGBuffer(device, settings.width, settings.height);
    if (attributes && (!targets.attributes || targets.attributes->pictures.size() < pictures))
        targets.attributes = makeAttributeTargets(device, settings.width, settings.height, pictures);
    if ((!attributes || settings.layers) && !targets.depth)
        targets.depth = makeDepthTarget(device, settings.width, settings.height, "depth");
}

void Renderer::begin(gpu::Commands& commands, std::span<const gpu::DeviceImage* const> colors,
                     const gpu::DeviceImage* depth, const ClearColor& clearColor, LoadTarget loadDepth)
{
    beginRendering(commands, colors, depth, targetFill.fill(commands, colors, clearColor), loadDepth);
}

void Renderer::drawBatches(gpu::Commands& commands, const FrameInputs& frame, SurfaceOutput output)
{
    for (const Batch& batch : frame.scene.plan.batches)
        if (output != SurfaceOutput::depth || hasDepthPass(batch.key))
            drawOne(commands, frame, batch, output);
}

void Renderer::drawOne(gpu::Commands& commands, const FrameInputs& frame, const Batch& batch, SurfaceOutput output)
{
    drawBatch(commands, surfacePipelines.get(frame.scene.plan, batch, output), batch, output, frame);
}

void Renderer::drawDepth(gpu::Commands& commands, const FrameInputs& frame)
{
    beginRendering(commands, {}, &*targets.depth, {}, LoadTarget::clear);
    hideOthers(commands, frame);
    drawBatches(commands, frame, SurfaceOutput::depth);
    commands.buffer.endRendering();
}

void Renderer::drawGBuffer(gpu::Commands& commands, const FrameInputs& frame)
{
    std::vector<const gpu::DeviceImage*> pointers;
    for (const gpu::DeviceImage& target : targets.gbuffer)
        pointers.push_back(&target);
    begin(commands, pointers, &*targets.depth, kClearToNothing, LoadTarget::clear);
    hideOthers(commands, frame);
    drawBatches(commands, frame, SurfaceOutput::gbuffer);
    commands.buffer.endRendering();
}

void Renderer::drawLighting(gpu::Commands& commands, const FrameInputs& frame)
{
    const ShadingPlan& plan = frame.scene.plan;
    for (std::size_t i = 0; i < plan.lightingClasses.size(); ++i) {
        gpu::Bindings bindings = frame.bindingsOf(plan.lightingClasses[i]);
        bindGBuffer(bindings, targets.gbuffer, pointSampler);
        const LightingForm form = lightingForm(plan, i);
        drawFullscreen(commands, imagePipeline("passes/lighting.frag", form.selected, form.description), bindings);
    }
}

void Renderer::drawAttributes(gpu::Commands& commands, const FrameInputs& frame)
{
    std::vector<const gpu::DeviceImage*> pointers;
    for (std::size_t i = 0; i < attributePictures(frame.scene.plan); ++i) // there may be more, of another plan
        pointers.push_back(&targets.attributes->pictures[i]);
    begin(commands, pointers, &targets.attributes->depth, kClearAttributes, LoadTarget::clear);
    hideOthers(commands, frame);
    for (const Batch& batch : frame.scene.plan.batches) {
        if (batch.shadingClass < 0)
            continue;
        commands.buffer.setStencilReference(vk::StencilFaceFlagBits::eFrontAndBack,
                                            static_cast<std::uint32_t>(batch.shadingClass + 1));
        drawOne(commands, frame, batch, SurfaceOutput::attributes);
    }
    commands.buffer.endRendering();
}

void Renderer::resolveAttributes(gpu::Commands& commands, const FrameInputs& frame)
{
    const ShadingPlan& plan = frame.scene.plan;
    commands.use(attributeUses(*targets.attributes));
    const std::array colors = {&targets.color};
    begin(commands, colors, &targets.attributes->depth, backgroundClear(plan), LoadTarget::readOnly);
    const std::vector<PixelBox> areas = classAreas(frame);
    for (std::size_t i = 0; i < plan.classes.size(); ++i) {
        if (areas[i].empty())
            continue;
        const ResolveForm form = resolveForm(plan, plan.classes[i]);
        const std::string selected = form.selected + flatUniformsText(device);
        commands.buffer.setStencilReference(vk::StencilFaceFlagBits::eFrontAndBack, static_cast<std::uint32_t>(i + 1));
        commands.buffer.setScissor(0, rectangleOf(areas[i])); // outside, even the test of the stencil costs
        drawFullscreen(commands,
                       imagePipeline("passes/resolve.frag", selected, form.description, "passes/resolve.vert"),
                       resolveBindings(frame, i, *targets.attributes, pointSampler));
    }
    commands.buffer.setScissor(0, vk::Rect2D{{0, 0}, {targets.color.shape.width, targets.color.shape.height}});
    drawBackground(commands, frame);
    commands.buffer.endRendering();
}

void Renderer::drawDirectly(gpu::Commands& commands, const FrameInputs& frame)
{
    const ShadingPlan& plan = frame.scene.plan;
    const std::array colors = {&targets.color};
    beginRendering(commands, colors, &targets.attributes->depth, kKeep, LoadTarget::keep);
    for (const Batch& batch : plan.batches)
        if (batch.shadingClass < 0)
            drawOne(commands, frame, batch, SurfaceOutput::color);
    drawBlended(commands, frame);
    commands.buffer.endRendering();
}

void Renderer::drawBlended(gpu::Commands& commands, const FrameInputs& frame)
{
    const dvec3 eye = cameraPosition(frame.camera);
    for (const Batch* batch : sortedBlended(frame.scene.plan, eye, forwardOf(frame.camera)))
        drawOne(commands, frame, *batch, SurfaceOutput::color);
}

void Renderer::drawSurfaces(gpu::Commands& commands, const FrameInputs& frame)
{
    const ShadingPlan& plan = frame.scene.plan;
    const RenderPath path = plan.path;
    if (path == RenderPath::deferred)
        commands.use(gbufferUses(targets.gbuffer));
    const std::array colors = {&targets.color};
    begin(commands, colors, &*targets.depth, backgroundClear(plan),
          path == RenderPath::forward ? LoadTarget::clear : LoadTarget::keep);
    if (path == RenderPath::forward)
        hideOthers(commands, frame);
    switch (path) {
    case RenderPath::forward:
        drawBatches(commands, frame, SurfaceOutput::color);
        break;
    case RenderPath::prepass:
        drawBatches(commands, frame, SurfaceOutput::colorAtDepth);
        break;
    case RenderPath::deferred:
        drawLighting(commands, frame);
        break;
    case RenderPath::attributes:
        break; // resolveAttributes
    }
    drawBackground(commands, frame);
    drawBlended(commands, frame);
    commands.buffer.endRendering();
}

void Renderer::drawSampleDepth(gpu::Commands& commands, const FrameInputs& frame)
{
    beginRendering(commands, {}, &targets.edges->sampleDepth, {}, LoadTarget::clear);
    drawBatches(commands, frame, SurfaceOutput::sampleDepth);
    commands.buffer.endRendering();
}

void Renderer::reconstruct(gpu::Commands& commands, const FrameInputs& frame)
{
    const EdgeTargets& edges = *targets.edges;
    gpu::copyImage(commands, targets.color, edges.result);
    const PixelBox area = surfaceArea(frame);
    if (area.empty())
        return; // no surface, no edge
    const bool attributes = frame.scene.plan.path == RenderPath::attributes;
    const gpu::DeviceImage& depth = attributes ? targets.attributes->depth : *targets.depth;
    const gpu::Bindings bindings = edgeBindings(frame, targets.color, depth, edges, pointSampler);
    commands.use({gpu::use(targets.color, gpu::Access::sampled),
                  gpu::use(depth, attributes ? gpu::Access::depthTest : gpu::Access::sampled),
                  gpu::use(edges.sampleDepth, gpu::Access::sampled)});
    beginRendering(commands, {}, &edges.edges, kKeep, LoadTarget::clear);
    commands.buffer.setScissor(0, rectangleOf(area));
    drawFullscreen(commands, imagePipeline("passes/edges.frag", "", edgesDescription()), bindings);
    commands.buffer.endRendering();
    const std::array colors = {&edges.result};
    beginRendering(commands, colors, &edges.edges, kKeep, LoadTarget::keep);
    commands.buffer.setScissor(0, rectangleOf(area));
    drawFullscreen(commands, imagePipeline("passes/reconstruct.frag", "", reconstructionDescription()), bindings);
    commands.buffer.endRendering();
}

void Renderer::run(const std::vector<Pass>& passes, const FrameInputs& frame, const PassObserver& observer)
{
    if (observer) {
        for (const Pass& pass : passes)
            observer(pass.name, [&] {
                gpu::Commands commands(device);
                useFrame(commands, frame);
                pass.record(commands);
                commands.submitAndWait();
            });
        return;
    }
    gpu::Commands commands(device);
    useFrame(commands, frame);
    for (const Pass& pass : passes)
        pass.record(commands);
    commands.submitAndWait();
}

void Renderer::drawColor(const DeviceScene& scene, const Camera& camera, const dvec2& offset, int picture,
                         const PassObserver& observer, std::span<const PixelBox> only)
{
    const RenderPath path = scene.plan.path;
    prepareTargets(scene.plan);
    FrameInputs frame = inputsOf(scene, camera, offset, picture);
    frame.only = only;
    std::vector<Pass> passes;
    if (path == RenderPath::prepass)
        passes.push_back({"depth", [&](gpu::Commands& commands) { drawDepth(commands, frame); }});
    if (path == RenderPath::deferred)
        passes.push_back({"G-buffer", [&](gpu::Commands& commands) { drawGBuffer(commands, frame); }});
    if (path == RenderPath::attributes) {
        passes.push_back({"attributes", [&](gpu::Commands& commands) { drawAttributes(commands, frame); }});
        passes.push_back({"shading", [&](gpu::Commands& commands) { resolveAttributes(commands, frame); }});
        if (drawsDirectly(scene.plan))
            passes.push_back({"surfaces", [&](gpu::Commands& commands) { drawDirectly(commands, frame); }});
    } else
        passes.push_back({"surfaces", [&](gpu::Commands& commands) { drawSurfaces(commands, frame); }});
    if (shadesOncePerPixel(scene.plan.settings)) {
        passes.push_back({"sample depth", [&](gpu::Commands& commands) { drawSampleDepth(commands, frame); }});
        passes.push_back({"reconstruction", [&](gpu::Commands& commands) { reconstruct(commands, frame); }});
    }
    run(passes, frame, observer);
}

void Renderer::drawFrame(const DeviceScene& scene, const Camera& camera, const PassObserver& observer)
{
    gpu::guarded(device, [&] { drawColor(scene, camera, dvec2(0.0), 0, observer, {}); });
}

Renderer::Pipelines Renderer::exchangePipelines(Pipelines others)
{
    return {.surfaces = surfacePipelines.exchange(std::move(others.surfaces)),
            .images = std::exchange(imagePipelines, std::move(others.images))};
}

const gpu::DeviceImage& Renderer::frame(const ShadingPlan& plan) const
{
    return shadesOncePerPixel(plan.settings) ? targets.edges->result : targets.color;
}

void Renderer::accumulate(const gpu::DeviceImage& sum, int index, int count)
{
    const gpu::Pipeline& pipeline =
        imagePipeline("passes/accumulate.frag", "",
                      {.name = "accumulate", .colorFormats = {kColorFormat}, .blend = gpu::Blend::weighted});
    gpu::Bindings bindings;
    bindings.set(shared::kBindSource, targets.color, tableSampler);
    gpu::Commands commands(device);
    commands.use({gpu::use(targets.color, gpu::Access::sampled)});
    const std::array sums = {&sum};
    begin(commands, sums, nullptr, index == 0 ? kClearToNothing : kKeep, LoadTarget::clear);
    const float weight = 1.0f / static_cast<float>(count);
    commands.buffer.setBlendConstants(std::array{weight, weight, weight, weight}.data());
    drawFullscreen(commands, pipeline, bindings);
    commands.buffer.endRendering();
    commands.submitAndWait();
}

std::vector<Layer> Renderer::drawLayers(const DeviceScene& scene, const Camera& camera)
{
    const FrameInputs frame = inputsOf(scene, camera, dvec2(0.0), 0);
    std::vector<gpu::DeviceImage> pictures;
    std::vector<const gpu::DeviceImage*> pointers;
    for (std::size_t i = 0; i < kLayerTargets; ++i)
        pictures.push_back(makeColorTarget(device, scene.plan.settings.width, scene.plan.settings.height, "layers"));
    for (const gpu::DeviceImage& picture : pictures)
        pointers.push_back(&picture);

    gpu::Commands commands(device);
    useFrame(commands, frame);
    begin(commands, pointers, &*targets.depth, kClearToNothing, LoadTarget::clear);
    for (const auto* list : {&scene.plan.batches, &scene.plan.blended})
        for (const Batch& batch : *list)
            drawOne(commands, frame, batch, SurfaceOutput::layers);
    commands.buffer.endRendering();
    commands.submitAndWait();

    std::vector<Image> images;
    for (const gpu::DeviceImage& picture : pictures)
        images.push_back(readBack(device, picture));
    return splitLayers(images, cameraPosition(camera));
}

Picture Renderer::render(const DeviceScene& scene, const Camera& camera, const std::function<void(int, int)>& progress,
                         std::span<const PixelBox> only)
{
    return gpu::guarded(device, [&] {
        const Settings& settings = scene.plan.settings;
        const int count = pictureCount(settings);
        const std::vector<dvec2> offsets = sampleOffsets(count);
        std::optional<gpu::DeviceImage> sum;
        if (count > 1)
            sum = makeColorTarget(device, settings.width, settings.height, "sum of samples");
        for (int i = 0; i < count; ++i) {
            drawColor(scene, camera, offsets[static_cast<std::size_t>(i)], i, {}, only);
            if (sum)
                accumulate(*sum, i, count);
            if (progress)
                progress(i + 1, count);
        }
        Picture picture = {.color = readBack(device, sum ? *sum : frame(scene.plan)), .layers = {}};
        if (settings.layers && only.empty())
            picture.layers = drawLayers(scene, camera);
        return picture;
    });
}

} // namespace torrance
