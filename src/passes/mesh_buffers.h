// The vertices and indices of a plan's primitives on the device: one buffer, a stream per attribute.
#pragma once

#include "gpu/buffer.h"
#include "plan/shading_plan.h"

#include <array>
#include <vector>

namespace torrance {

/// The attributes in the order of their shader locations.
enum class VertexAttribute
{
    position,
    normal,
    tangent,
    uv0,
    uv1,
    color,
};
inline constexpr std::size_t kAttributeCount = 6;

struct PrimitiveRange
{
    std::array<vk::DeviceSize, kAttributeCount> streams =
        {}; // byte offsets; meaningless for an attribute that is not there
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0;
    std::uint32_t vertexCount = 0;
    dvec3 center = dvec3(0.0); // taken out of the positions: see kRecentreRatio
};

struct MeshBuffers
{
    gpu::Buffer vertices;
    gpu::Buffer indices;
    std::vector<PrimitiveRange> ranges; // per Scene::primitives
};

/// A primitive whose vertices lie further from its origin than this many times its size is moved to its centre before
/// it is rounded to float, and its transform moved back in double: at 1e6 metres a float steps by 6 cm.
inline constexpr double kRecentreRatio = 16.0;

/// Uploads what the plan draws; makes the tangents that its shaders need and the file lacks.
MeshBuffers makeMeshBuffers(const gpu::Device& device, const Scene& scene, const ShadingPlan& plan);

/// Whether that is the same for two plans of one scene.
bool makesSameBuffers(const Scene& scene, const ShadingPlan& a, const ShadingPlan& b);

} // namespace torrance
