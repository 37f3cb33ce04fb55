#include "passes/surface_pass.h"

#include "passes/targets.h"
#include "plan/deferred_plan.h"
#include "shaders/shared/bindings.h"

#include <algorithm>
#include <array>

namespace torrance {
namespace {

bool isShape(SurfaceKind kind)
{
    return kind == SurfaceKind::sphere || kind == SurfaceKind::plane;
}

// The streams that a key's vertex shader reads, in the order of their locations.
std::vector<VertexAttribute> attributesOf(const ShaderKey& key)
{
    if (isShape(key.surface))
        return {};
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

// What the fragment shader of an output is called, how many targets it has, and its specialization constants.
struct OutputForm
{
    const char* fragment;
    std::size_t targets;
    std::vector<std::uint32_t> constants;
};

OutputForm formOf(const ShadingPlan& plan, const ShaderKey& key, SurfaceOutput output)
{
    switch (output) {
    case SurfaceOutput::layers:
        return {"passes/surface_layers.frag", kLayerTargets, {}};
    case SurfaceOutput::gbuffer:
        return {"passes/gbuffer.frag", kGBufferTargets, {lightingClassIndex(plan, key)}};
    case SurfaceOutput::color:
        break;
    }
    return {plan.settings.view ? "passes/surface_view.frag" : "passes/surface.frag", 1, shadingConstants(plan)};
}

gpu::PipelineDescription describePipeline(const ShaderKey& key, SurfaceOutput output, const OutputForm& form)
{
    const bool blends = key.alphaMode == AlphaMode::blend && output == SurfaceOutput::color;
    gpu::PipelineDescription description = {
        .name = key.name(),
        .topology = topologyOf(key.surface),
        .colorFormats = std::vector(form.targets, kColorFormat),
        .depthFormat = kDepthFormat,
        .depth = blends ? gpu::DepthUse::testOnly : gpu::DepthUse::testAndWrite,
        .blend = blends ? gpu::Blend::premultiplied : gpu::Blend::replace,
        .constants = form.constants,
    };
    for (const VertexAttribute attribute : attributesOf(key))
        description.streams.push_back(streamOf(attribute));
    return description;
}

void bindStreams(gpu::Commands& commands, const ShaderKey& key, const MeshBuffers& meshes, const PrimitiveRange& range)
{
    std::vector<vk::Buffer> buffers;
    std::vector<vk::DeviceSize> offsets;
    for (const VertexAttribute attribute : attributesOf(key)) {
        buffers.push_back(*meshes.vertices.handle);
        offsets.push_back(range.streams[static_cast<std::size_t>(attribute)]);
    }
    commands.buffer.bindVertexBuffers(0, buffers, offsets);
}

void drawOnce(gpu::Commands& commands, const Batch& batch, const Draw& draw, const MeshBuffers& meshes,
              vk::CullModeFlags cull)
{
    const auto first = static_cast<std::uint32_t>(draw.firstInstance),
               count = static_cast<std::uint32_t>(draw.instanceCount);
    if (isShape(batch.key.surface)) {
        commands.buffer.setCullMode(vk::CullModeFlagBits::eNone); // the shader tells the sides apart
        commands.buffer.draw(3, count, 0, first);
        return;
    }
    const PrimitiveRange& range = meshes.ranges[static_cast<std::size_t>(draw.primitive)];
    commands.buffer.setCullMode(cull);
    commands.buffer.setFrontFace(draw.mirrored ? vk::FrontFace::eClockwise : vk::FrontFace::eCounterClockwise);
    bindStreams(commands, batch.key, meshes, range);
    commands.buffer.drawIndexed(range.indexCount, count, range.firstIndex, 0, first);
}

} // namespace

std::vector<std::uint32_t> shadingConstants(const ShadingPlan& plan)
{
    std::vector<std::uint32_t> constants;
    for (const int count : plan.lightCounts)
        constants.push_back(static_cast<std::uint32_t>(count));
    constants.push_back(static_cast<std::uint32_t>(plan.settings.environmentSamples));
    constants.push_back(static_cast<std::uint32_t>(plan.settings.lightSamples));
    return constants;
}

const gpu::Pipeline& SurfacePipelines::get(const ShadingPlan& plan, const ShaderKey& key, SurfaceOutput output)
{
    const std::string selected = selectedText(plan, key);
    const OutputForm form = formOf(plan, key, output);
    std::string identity = selected + form.fragment;
    for (const std::uint32_t constant : form.constants)
        identity += " " + std::to_string(constant);
    if (const auto found = pipelines.find(identity); found != pipelines.end())
        return found->second;
    const gpu::CompiledShader vertex =
        shaders.get(isShape(key.surface) ? "passes/shape.vert" : "passes/surface.vert", selected);
    const gpu::CompiledShader fragment = shaders.get(form.fragment, selected);
    return pipelines.emplace(identity, gpu::makePipeline(device, vertex, fragment, describePipeline(key, output, form)))
        .first->second;
}

void drawBatch(gpu::Commands& commands, const gpu::Pipeline& pipeline, gpu::Bindings bindings, const Batch& batch,
               const MeshBuffers& meshes, const Textures& textures)
{
    constexpr std::array kTextureBindings = {shared::kBindBaseColor, shared::kBindMetallicRoughness,
                                             shared::kBindNormal, shared::kBindOcclusion, shared::kBindEmissive};
    for (std::size_t slot = 0; slot < kTextureBindings.size(); ++slot)
        if (const int texture = batch.textures[slot]; texture >= 0)
            bindings.set(kTextureBindings[slot], textures.image(texture, contentOf(slot)), textures.sampler(texture));

    commands.buffer.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline.handle);
    bindings.push(commands.buffer, pipeline);
    commands.buffer.bindIndexBuffer(*meshes.indices.handle, 0, vk::IndexType::eUint32);
    using Cull = vk::CullModeFlagBits;
    for (const Draw& draw : batch.draws)
        if (!batch.key.doubleSided)
            drawOnce(commands, batch, draw, meshes, Cull::eBack);
        else if (batch.key.alphaMode != AlphaMode::blend)
            drawOnce(commands, batch, draw, meshes, Cull::eNone);
        else
            for (const Cull cull : {Cull::eFront, Cull::eBack}) // the far side shows through the near one
                drawOnce(commands, batch, draw, meshes, cull);
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
