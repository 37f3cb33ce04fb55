#include "passes/surface_pass.h"

#include "brdf/environment.h"
#include "passes/targets.h"
#include "plan/attribute_plan.h"
#include "plan/deferred_plan.h"
#include "scene/pixel_box.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/instance.h"
#include "shaders/shared/instance_attributes.h"

#include <algorithm>
#include <array>

namespace torrance {
namespace {

bool isShape(SurfaceKind kind)
{
    return kind == SurfaceKind::sphere || kind == SurfaceKind::plane;
}

// Depth of an opaque mesh: of all that decides the text of a surface's shaders, only the topology matters.
bool isPlainDepth(const ShaderKey& key, SurfaceOutput output)
{
    const bool depth = output == SurfaceOutput::depth || output == SurfaceOutput::sampleDepth;
    return depth && key.alphaMode != AlphaMode::mask;
}

// The streams that a key's vertex shader reads, in the order of their locations.
std::vector<VertexAttribute> attributesOf(const ShaderKey& key, SurfaceOutput output)
{
    if (isShape(key.surface))
        return {};
    if (isPlainDepth(key, output))
        return {VertexAttribute::position};
    std::vector<VertexAttribute> attributes = {VertexAttribute::position};
    if (key.normals)
        attributes.push_back(VertexAttribute::normal);
    if (key.tangents())
        attributes.push_back(VertexAttribute::tangent);
    if (key.usesUv(0))
        attributes.push_back(VertexAttribute::uv0);
    if (key.usesUv(1))
        attributes.push_back(VertexAttribute::uv1);
    if (key.colors)
        attributes.push_back(VertexAttribute::color);
    return attributes;
}

gpu::VertexStream streamOf(VertexAttribute attribute)
{
    const auto location = static_cast<std::uint32_t>(attribute);
    switch (attribute) {
    case VertexAttribute::position:
    case VertexAttribute::normal:
        return {location, vk::Format::eR32G32B32Sfloat, sizeof(vec3)};
    case VertexAttribute::uv0:
    case VertexAttribute::uv1:
        return {location, vk::Format::eR32G32Sfloat, sizeof(vec2)};
    case VertexAttribute::tangent:
    case VertexAttribute::color:
        break;
    }
    return {location, vk::Format::eR32G32B32A32Sfloat, sizeof(vec4)};
}

// A part of an instance that a vertex shader reads.
struct InstanceStream
{
    std::uint32_t location;
    vk::Format format;
    std::uint32_t offset; // bytes, in shared::Instance
};

std::vector<InstanceStream> instanceStreamsOf(const ShaderKey& key, SurfaceOutput output)
{
    if (isShape(key.surface))
        return {};
    constexpr auto kLinear = static_cast<std::uint32_t>(offsetof(shared::Instance, linear));
    constexpr auto kNormal = static_cast<std::uint32_t>(offsetof(shared::Instance, normal));
    constexpr auto kColumn = static_cast<std::uint32_t>(sizeof(vec3));
    constexpr vk::Format kVec3 = vk::Format::eR32G32B32Sfloat, kVec4 = vk::Format::eR32G32B32A32Sfloat;
    static_assert(offsetof(shared::Instance, handedness) == kNormal + 3 * kColumn);
    static_assert(offsetof(shared::Instance, object) == offsetof(shared::Instance, material) + 4);
    std::vector<InstanceStream> streams;
    for (std::uint32_t i = 0; i < 3; ++i)
        streams.push_back({shared::kInstanceLinear + i, kVec3, kLinear + i * kColumn});
    streams.push_back({shared::kInstanceTranslation, kVec3, offsetof(shared::Instance, translation)});
    if (key.normals && !isPlainDepth(key, output))
        for (std::uint32_t i = 0; i < 3; ++i)
            streams.push_back({shared::kInstanceNormal + i, i < 2 ? kVec3 : kVec4, kNormal + i * kColumn});
    if (output == SurfaceOutput::layers)
        streams.push_back({shared::kInstanceIds, vk::Format::eR32G32Uint, offsetof(shared::Instance, material)});
    return streams;
}

// What the fragment shader of an output is called, how many targets it has, and its specialization constants.
struct OutputForm
{
    const char* fragment; // none: ""
    std::size_t targets;
    std::vector<std::uint32_t> constants;
};

OutputForm formOf(const ShadingPlan& plan, const ShaderKey& key, SurfaceOutput output)
{
    switch (output) {
    case SurfaceOutput::depth:
    case SurfaceOutput::sampleDepth:
        return {isPlainDepth(key, output) ? "" : "passes/depth_masked.frag", 0, {}};
    case SurfaceOutput::layers:
        return {"passes/surface_layers.frag", kLayerTargets, {}};
    case SurfaceOutput::attributes:
        return {"passes/attributes.frag", attributePictures(plan), {}};
    case SurfaceOutput::gbuffer:
        return {"passes/gbuffer.frag", kGBufferTargets, {lightingClassIndex(plan, key)}};
    case SurfaceOutput::color:
    case SurfaceOutput::colorAtDepth:
        break;
    }
    return {plan.settings.view ? "passes/surface_view.frag" : "passes/surface.frag", 1, shadingConstants(plan, key)};
}

// passes/surface.frag behind passes/surface.vert.
bool isShaded(const ShadingPlan& plan, const ShaderKey& key, SurfaceOutput output)
{
    const bool colors = output == SurfaceOutput::color || output == SurfaceOutput::colorAtDepth;
    return colors && !plan.settings.view && !isShape(key.surface);
}

gpu::DepthUse depthUseOf(const ShaderKey& key, SurfaceOutput output)
{
    if (output == SurfaceOutput::colorAtDepth && hasDepthPass(key))
        return gpu::DepthUse::equal;
    const bool blends = key.alphaMode == AlphaMode::blend && output == SurfaceOutput::color;
    return blends ? gpu::DepthUse::testOnly : gpu::DepthUse::testAndWrite;
}

gpu::PipelineDescription describePipeline(const ShadingPlan& plan, const ShaderKey& key, SurfaceOutput output,
                                          const OutputForm& form)
{
    const bool attributes = output == SurfaceOutput::attributes;
    const bool besideClasses =
        plan.path == RenderPath::attributes && output != SurfaceOutput::layers && output != SurfaceOutput::sampleDepth;
    const bool blends = key.alphaMode == AlphaMode::blend && output == SurfaceOutput::color;
    gpu::PipelineDescription description = {
        .name = key.name(),
        .topology = topologyOf(key.surface),
        .colorFormats = std::vector(form.targets, attributes ? kAttributeFormat : kColorFormat),
        .depthFormat = besideClasses ? kDepthStencilFormat : kDepthFormat,
        .depth = depthUseOf(key, output),
        .stencil = attributes ? gpu::StencilUse::write : gpu::StencilUse::none,
        .blend = blends ? gpu::Blend::premultiplied : gpu::Blend::replace,
        .samples = output == SurfaceOutput::sampleDepth ? vk::SampleCountFlagBits::e4 : vk::SampleCountFlagBits::e1,
        .constants = form.constants,
    };
    for (const VertexAttribute attribute : attributesOf(key, output))
        description.streams.push_back(streamOf(attribute));
    for (const InstanceStream& stream : instanceStreamsOf(key, output))
        description.streams.push_back({stream.location, stream.format, sizeof(shared::Instance), true});
    return description;
}

void bindStreams(gpu::Commands& commands, const ShaderKey& key, SurfaceOutput output, const FrameInputs& frame,
                 const Draw& draw, const PrimitiveRange& range)
{
    std::vector<vk::Buffer> buffers;
    std::vector<vk::DeviceSize> offsets;
    for (const VertexAttribute attribute : attributesOf(key, output)) {
        buffers.push_back(*frame.scene.meshes->vertices.handle);
        const bool second = attribute == VertexAttribute::uv0 && draw.uvSet == 1;
        offsets.push_back(range.streams[static_cast<std::size_t>(second ? VertexAttribute::uv1 : attribute)]);
    }
    for (const InstanceStream& stream : instanceStreamsOf(key, output)) {
        buffers.push_back(*frame.instances.handle);
        offsets.push_back(stream.offset);
    }
    commands.buffer.bindVertexBuffers(0, buffers, offsets);
}

void drawTriangles(gpu::Commands& commands, SurfaceOutput output, const Draw& draw, const FrameInputs& frame,
                   const PrimitiveRange& range)
{
    constexpr vk::IndexType kType = vk::IndexType::eUint32;
    // What shows at no pixel's centre may show at another sample of it.
    const bool centres = output != SurfaceOutput::sampleDepth;
    const std::vector<VisibleTriangles::Range>* visible = frame.visible && centres ? frame.visible->of(draw) : nullptr;
    if (!visible) {
        commands.buffer.bindIndexBuffer(*frame.scene.meshes->indices.handle, 0, kType);
        commands.buffer.drawIndexed(range.indexCount, static_cast<std::uint32_t>(draw.instanceCount), range.firstIndex,
                                    0, static_cast<std::uint32_t>(draw.firstInstance));
        return;
    }
    commands.buffer.bindIndexBuffer(*frame.visible->indices.handle, 0, kType);
    for (const VisibleTriangles::Range& part : *visible)
        commands.buffer.drawIndexed(part.indexCount, 1, part.firstIndex, 0, part.instance);
}

void drawOnce(gpu::Commands& commands, const Batch& batch, SurfaceOutput output, const Draw& draw,
              const FrameInputs& frame, vk::CullModeFlags cull)
{
    if (isShape(batch.key.surface)) {
        commands.buffer.setCullMode(vk::CullModeFlagBits::eNone); // the shader tells the sides apart
        commands.buffer.draw(3, 1, 0, 0);
        return;
    }
    const PrimitiveRange& range = frame.scene.meshes->ranges[static_cast<std::size_t>(draw.primitive)];
    commands.buffer.setCullMode(cull);
    commands.buffer.setFrontFace(draw.mirrored ? vk::FrontFace::eClockwise : vk::FrontFace::eCounterClockwise);
    bindStreams(commands, batch.key, output, frame, draw, range);
    drawTriangles(commands, output, draw, frame, range);
}

void drawSides(gpu::Commands& commands, const Batch& batch, SurfaceOutput output, const Draw& draw,
               const FrameInputs& frame, const PixelBox& seen)
{
    using Cull = vk::CullModeFlagBits;
    if (hidesBacks(batch, draw, seen))
        drawOnce(commands, batch, output, draw, frame, Cull::eBack);
    else if (batch.key.alphaMode != AlphaMode::blend)
        drawOnce(commands, batch, output, draw, frame, Cull::eNone);
    else
        for (const Cull cull : {Cull::eFront, Cull::eBack}) // the far side shows through the near one
            drawOnce(commands, batch, output, draw, frame, cull);
}

} // namespace

vk::PrimitiveTopology topologyOf(SurfaceKind kind)
{
    switch (kind) {
    case SurfaceKind::lines:
        return vk::PrimitiveTopology::eLineList;
    case SurfaceKind::points:
        return vk::PrimitiveTopology::ePointList;
    default:
        return vk::PrimitiveTopology::eTriangleList;
    }
}

const char* flatUniformsText(const gpu::Device& device)
{
    return device.description.isProcessor() ? "#define FLAT_UNIFORMS\n" : "";
}

std::vector<std::uint32_t> shadingConstants(const ShadingPlan& plan, const ShaderKey& key)
{
    const Settings& choice = choiceOf(plan, key);
    std::vector<std::uint32_t> constants;
    for (const int count : plan.lightCounts)
        constants.push_back(static_cast<std::uint32_t>(count));
    constants.push_back(static_cast<std::uint32_t>(choice.environmentSamples));
    constants.push_back(static_cast<std::uint32_t>(choice.lightSamples));
    constants.push_back(static_cast<std::uint32_t>(brdf::lampPointCount(choice.environmentSamples)));
    return constants;
}

const gpu::Pipeline& SurfacePipelines::get(const ShadingPlan& plan, const Batch& batch, SurfaceOutput output)
{
    const ShaderKey& key = batch.key;
    const bool plainDepth = isPlainDepth(key, output);
    std::string selected = plainDepth                            ? ""
                           : output == SurfaceOutput::attributes ? attributesText(plan, batch)
                                                                 : selectedText(plan, key);
    if (output == SurfaceOutput::sampleDepth && !plainDepth)
        selected += "#define AT_SAMPLES\n"; // inputs are those of the sample, not of the pixel's centre
    if (isShaded(plan, key, output))
        selected += flatUniformsText(device);
    const OutputForm form = formOf(plan, key, output);
    const gpu::PipelineDescription description = describePipeline(plan, key, output, form);
    std::string identity = selected + form.fragment + vk::to_string(description.topology) +
                           std::to_string(static_cast<int>(description.depth)) +
                           vk::to_string(*description.depthFormat) + vk::to_string(description.samples);
    for (const std::uint32_t constant : form.constants)
        identity += " " + std::to_string(constant);
    if (const auto found = pipelines.find(identity); found != pipelines.end())
        return found->second;
    const char* vertexEntry = isShape(key.surface)              ? "passes/shape.vert"
                              : plainDepth                      ? "passes/depth.vert"
                              : output == SurfaceOutput::layers ? "passes/surface_ids.vert"
                                                                : "passes/surface.vert";
    const gpu::CompiledShader vertex = shaders.get(vertexEntry, selected);
    return pipelines
        .emplace(identity, plainDepth
                               ? gpu::makeDepthPipeline(device, vertex, description)
                               : gpu::makePipeline(device, vertex, shaders.get(form.fragment, selected), description))
        .first->second;
}

bool hasDepthPass(const ShaderKey& key)
{
    return !isShape(key.surface);
}

void bindTextures(gpu::Bindings& bindings, const TextureSet& set, const Textures& textures)
{
    constexpr std::array kBindings = {shared::kBindBaseColor, shared::kBindScalars,
                                      shared::kBindNormal,    shared::kBindOcclusion,
                                      shared::kBindEmissive,  shared::kBindTexelWords}; // by TextureRole
    for (std::size_t role = 0; role < kBindings.size(); ++role)
        if (const int texture = set[role]; texture >= 0)
            bindings.set(kBindings[role], textures.image(texture), textures.sampler(texture));
}

void drawBatch(gpu::Commands& commands, const gpu::Pipeline& pipeline, const Batch& batch, SurfaceOutput output,
               const FrameInputs& frame)
{
    gpu::Bindings bindings = frame.bindingsOf(batch.key);
    bindTextures(bindings, batch.textures, *frame.scene.textures);
    if (const auto role = levelRole(frame.scene.plan, batch.textures); role && output == SurfaceOutput::attributes) {
        const int texture = batch.textures[static_cast<std::size_t>(*role)];
        bindings.set(shared::kBindLevel, frame.scene.textures->image(texture), frame.scene.textures->sampler(texture));
    }
    commands.buffer.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline.handle);
    int bound = -1; // the block of a material
    const Settings& settings = frame.scene.plan.settings;
    for (const Draw& draw : batch.draws) {
        const PixelBox seen = pixelBoxOf(frame.camera, settings.width, settings.height, draw.bounds);
        if (seen.empty())
            continue;
        if (draw.block != bound || isShape(batch.key.surface)) {
            frame.scene.materials.bind(bindings, static_cast<std::size_t>(draw.block));
            if (isShape(batch.key.surface))
                frame.shapeInstances.bind(bindings, static_cast<std::size_t>(draw.firstInstance));
            bindings.push(commands.buffer, pipeline);
            bound = draw.block;
        }
        drawSides(commands, batch, output, draw, frame, seen);
    }
}

std::vector<const Batch*> sortedBlended(const ShadingPlan& plan, const dvec3& eye, const dvec3& forward)
{
    std::vector<std::pair<double, const Batch*>> keyed;
    for (const Batch& batch : plan.blended) {
        const PlannedInstance& instance = plan.instances[static_cast<std::size_t>(batch.draws.front().firstInstance)];
        keyed.emplace_back(-glm::dot(instance.center - eye, forward), &batch);
    }
    std::ranges::stable_sort(keyed, {}, [](const auto& k) { return k.first; });
    std::vector<const Batch*> sorted;
    for (const auto& [distance, batch] : keyed)
        sorted.push_back(batch);
    return sorted;
}

} // namespace torrance
