// A line around one instance of a scene, as a picture of its own to be laid over the scene's.
#pragma once

#include "gpu/pipeline.h"
#include "gpu/shader_library.h"
#include "passes/device_scene.h"

#include <map>

namespace torrance {

class OutlinePass
{
public:
    OutlinePass(const gpu::Device& device, gpu::ShaderLibrary& shaders);

    /// White with straight alpha: 1 beside what the instance (Scene::instances) covers, hidden or not, and 0 elsewhere.
    /// Holes of alpha masks count as surface. Valid until the next call; the one of the call before must not be in use
    /// any more.
    const gpu::DeviceImage& draw(const DeviceScene& scene, const Camera& camera, int instance, const ivec2& size);

private:
    const gpu::Pipeline& silhouette(Topology topology);

    const gpu::Device& device;
    gpu::ShaderLibrary& shaders;
    vk::raii::Sampler sampler;
    std::map<Topology, gpu::Pipeline> silhouettes;
    gpu::Pipeline line;
    gpu::DeviceImage marks, picture;
};

} // namespace torrance
