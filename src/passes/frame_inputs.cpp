#include "passes/frame_inputs.h"

#include "passes/frame_data.h"
#include "prepare/environment_maps.h"
#include "scene/camera_view.h"
#include "shaders/shared/bindings.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

namespace torrance {
namespace {

template <typename T>
std::span<const std::byte> bytesOf(const std::vector<T>& items)
{
    return std::as_bytes(std::span(items));
}

shared::Frame frameOf(const DeviceScene& scene, const EnvironmentImages& environment, const Camera& camera,
                      const dvec2& offset, int picture)
{
    const int levels = environment.specular ? static_cast<int>(environment.specular->shape.mips) : 0;
    const int panoramaWidth = environment.panorama ? static_cast<int>(environment.panorama->shape.width) : 0;
    shared::Frame frame = makeFrame(scene.scene, scene.plan, camera, offset, levels, panoramaWidth);
    std::ranges::copy(environment.harmonics, frame.irradianceHarmonics);
    frame.lampDensities = vec2(environment.lampDensities.wide, environment.lampDensities.small);
    if (environment.background) {
        const double roughness = scene.plan.settings.backgroundBlur;
        frame.panoramaLevel =
            static_cast<float>(alphaLevel(roughness * roughness, static_cast<int>(environment.background->shape.mips)));
    }
    frame.picture = static_cast<std::uint32_t>(picture);
    return frame;
}

// The frame and its lights as they lie in the shaders' scalar layout.
std::vector<std::byte> frameBlock(const shared::Frame& frame, const std::vector<shared::Light>& lights)
{
    constexpr std::size_t kBytes = sizeof(shared::Frame) + shared::kMaxLights * sizeof(shared::Light);
    static_assert(sizeof(shared::Frame) % alignof(shared::Light) == 0 && kBytes <= 64 << 10);
    std::vector<std::byte> block(kBytes);
    std::memcpy(block.data(), &frame, sizeof frame);
    std::ranges::copy(bytesOf(lights), block.begin() + sizeof frame);
    return block;
}

gpu::Bindings bindingsOf(const gpu::Buffer& frame, const EnvironmentImages& environment, const FrameSamplers& samplers)
{
    gpu::Bindings bindings;
    bindings.set(shared::kBindFrame, frame);
    if (environment.specular)
        bindings.set(shared::kBindEnvironmentSpecular, *environment.specular, samplers.table);
    if (environment.diffuse)
        bindings.set(shared::kBindEnvironmentDiffuse, *environment.diffuse, samplers.table);
    if (environment.radiance)
        bindings.set(shared::kBindEnvironmentRadiance, *environment.radiance, samplers.table);
    if (environment.lamps)
        bindings.set(shared::kBindEnvironmentLamps, *environment.lamps, samplers.table);
    if (environment.dfg)
        bindings.set(shared::kBindDfg, *environment.dfg, samplers.table);
    if (environment.background)
        bindings.set(shared::kBindBackground, *environment.background, samplers.table);
    if (environment.panorama)
        bindings.set(shared::kBindPanorama, *environment.panorama, samplers.panorama);
    return bindings;
}

} // namespace

FrameInputs makeFrameInputs(const gpu::Device& device, const DeviceScene& scene, const Camera& camera,
                            const FrameSamplers& samplers, const dvec2& offset, int picture, TriangleCulling& culling)
{
    using Usage = vk::BufferUsageFlagBits;
    const dvec3 eye = cameraPosition(camera);
    const std::vector<shared::Instance> instances = makeInstances(scene.plan, *scene.meshes, eye);
    const std::size_t shapeInstances = scene.scene.shapes.empty() ? 0 : instances.size();
    FrameInputs frame = {.scene = scene,
                         .camera = camera,
                         .frames = {},
                         .instances = gpu::makeBuffer(device, bytesOf(instances), Usage::eVertexBuffer, "instances"),
                         .shapeInstances =
                             gpu::makeUniformBlocks(device, shared::kBindInstance,
                                                    std::span(instances).first(shapeInstances), "shape instances"),
                         .bindings = {},
                         .visible = nullptr};
    for (const EnvironmentImages& environment : scene.environments) {
        const shared::Frame own = frameOf(scene, environment, camera, offset, picture);
        if (frame.frames.empty()) // where things are is the same in all
            frame.visible = culling.find(scene, camera, own, instances);
        frame.frames.push_back(gpu::makeBuffer(device,
                                               frameBlock(own, makeLights(scene.plan, environment.lampPoints, eye)),
                                               Usage::eUniformBuffer, "frame"));
        frame.bindings.push_back(bindingsOf(frame.frames.back(), environment, samplers));
    }
    return frame;
}

void useFrame(gpu::Commands& commands, const FrameInputs& frame)
{
    std::vector<gpu::ImageUse> images = frame.scene.textures->uses();
    for (const EnvironmentImages& e : frame.scene.environments)
        for (const gpu::DeviceImage* image :
             {e.specular, e.diffuse, e.radiance, e.lamps, e.dfg, e.panorama, e.background})
            if (image)
                images.push_back(gpu::use(*image, gpu::Access::sampled));
    std::vector<gpu::BufferUse> buffers = {gpu::use(frame.instances, gpu::Access::vertexRead),
                                           gpu::use(frame.shapeInstances.buffer, gpu::Access::shaderRead),
                                           gpu::use(frame.scene.materials.buffer, gpu::Access::shaderRead),
                                           gpu::use(frame.scene.meshes->vertices, gpu::Access::vertexRead),
                                           gpu::use(frame.scene.meshes->indices, gpu::Access::vertexRead)};
    for (const gpu::Buffer& block : frame.frames)
        buffers.push_back(gpu::use(block, gpu::Access::shaderRead));
    if (frame.visible)
        buffers.push_back(gpu::use(frame.visible->indices, gpu::Access::vertexRead));
    commands.use(images, buffers);
}

} // namespace torrance
