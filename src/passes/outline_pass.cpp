#include "passes/outline_pass.h"

#include "passes/fullscreen.h"
#include "passes/sampler.h"
#include "passes/surface_pass.h"
#include "passes/targets.h"
#include "scene/camera_view.h"
#include "shaders/shared/bindings.h"

#include <array>

namespace torrance {
namespace {

constexpr vk::Format kMarkFormat = vk::Format::eR8Unorm, kPictureFormat = vk::Format::eR8G8B8A8Unorm;

gpu::DeviceImage makeTarget(const gpu::Device& device, const ivec2& size, vk::Format format, const char* name)
{
    using Usage = vk::ImageUsageFlagBits;
    return gpu::makeImage(
        device,
        {.width = static_cast<std::uint32_t>(size.x), .height = static_cast<std::uint32_t>(size.y), .format = format},
        Usage::eColorAttachment | Usage::eSampled | Usage::eTransferSrc, name);
}

} // namespace

OutlinePass::OutlinePass(const gpu::Device& d, gpu::ShaderLibrary& s)
    : device(d), shaders(s), sampler(makePointSampler(d)),
      line(gpu::makePipeline(d, s.get("passes/fullscreen.vert", ""), s.get("passes/outline.frag", ""),
                             {.name = "outline", .colorFormats = {kPictureFormat}}))
{
}

const gpu::Pipeline& OutlinePass::silhouette(Topology topology)
{
    if (const auto found = silhouettes.find(topology); found != silhouettes.end())
        return found->second;
    return silhouettes
        .emplace(topology, gpu::makePipeline(device, shaders.get("passes/silhouette.vert", ""),
                                             shaders.get("passes/silhouette.frag", ""),
                                             {.name = "silhouette",
                                              .streams = {{0, vk::Format::eR32G32B32Sfloat, sizeof(vec3)}},
                                              .topology = topologyOf(surfaceKindOf(topology)),
                                              .colorFormats = {kMarkFormat}}))
        .first->second;
}

const gpu::DeviceImage& OutlinePass::draw(const DeviceScene& scene, const Camera& camera, int index, const ivec2& size)
{
    const Instance& instance = scene.scene.instances[static_cast<std::size_t>(index)];
    const PrimitiveRange& range = scene.meshes->ranges[static_cast<std::size_t>(instance.primitive)];
    const Topology topology = scene.scene.primitives[static_cast<std::size_t>(instance.primitive)].topology;
    dmat4 worldFromVertex = instance.worldFromObject;
    worldFromVertex[3] = instance.worldFromObject * dvec4(range.center, 1.0);
    // One matrix, rounded last: what the vertices are multiplied with is small, however far away they stand.
    const mat4 block(projectionMatrix(camera, double(size.x) / size.y) * viewFromWorld(camera) * worldFromVertex);
    const ivec2 last = size - 1;
    const auto blockOf = [&](const auto& value, const char* name) {
        return gpu::makeBuffer(device, std::as_bytes(std::span(&value, 1)), vk::BufferUsageFlagBits::eUniformBuffer,
                               name);
    };
    const gpu::Buffer place = blockOf(block, "place"), sides = blockOf(last, "size");
    if (!*marks.handle || ivec2(marks.shape.width, marks.shape.height) != size) {
        marks = makeTarget(device, size, kMarkFormat, "silhouette");
        picture = makeTarget(device, size, kPictureFormat, "outline");
    }
    gpu::Commands commands(device);
    commands.use({}, {gpu::use(scene.meshes->vertices, gpu::Access::vertexRead),
                      gpu::use(scene.meshes->indices, gpu::Access::vertexRead),
                      gpu::use(place, gpu::Access::shaderRead), gpu::use(sides, gpu::Access::shaderRead)});
    beginRendering(commands, std::array{&std::as_const(marks)}, nullptr, kClearToNothing, LoadTarget::clear);
    const gpu::Pipeline& pipeline = silhouette(topology);
    gpu::Bindings bindings;
    bindings.set(shared::kBindFrame, place);
    commands.buffer.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline.handle);
    bindings.push(commands.buffer, pipeline);
    commands.buffer.bindVertexBuffers(0, *scene.meshes->vertices.handle,
                                      range.streams[static_cast<std::size_t>(VertexAttribute::position)]);
    commands.buffer.bindIndexBuffer(*scene.meshes->indices.handle, 0, vk::IndexType::eUint32);
    commands.buffer.drawIndexed(range.indexCount, 1, range.firstIndex, 0, 0);
    commands.buffer.endRendering();
    commands.use({gpu::use(marks, gpu::Access::sampled)});
    beginRendering(commands, std::array{&std::as_const(picture)}, nullptr, kKeep, LoadTarget::clear);
    gpu::Bindings read;
    read.set(shared::kBindFrame, sides);
    read.set(shared::kBindSource, marks, sampler);
    drawFullscreen(commands, line, read);
    commands.buffer.endRendering();
    commands.use({gpu::use(picture, gpu::Access::sampled)});
    commands.submitAndWait();
    return picture;
}

} // namespace torrance
