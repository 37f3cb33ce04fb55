// A scene on a device, ready to be drawn.
#pragma once

#include "gpu/uniform_blocks.h"
#include "passes/environment_upload.h"
#include "passes/mesh_buffers.h"
#include "passes/texture_upload.h"
#include "plan/shading_plan.h"

#include <memory>
#include <vector>

namespace torrance {

/// Scene, plan and the renderer that made it must outlive it.
struct DeviceScene
{
    const Scene& scene;
    const ShadingPlan& plan;
    std::shared_ptr<const MeshBuffers> meshes; // these two outlast a plan that changes nothing of them
    std::shared_ptr<const Textures> textures;
    std::vector<EnvironmentImages> environments; // by ShadingPlan::choices
    gpu::UniformBlocks materials;                // by ShadingPlan::blocks
    gpu::UniformBlocks classMaterials;           // of the attributes path: attribute_pass.h
};

} // namespace torrance
