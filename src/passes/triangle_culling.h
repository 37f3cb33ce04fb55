// The triangles that a frame shows, as indices of its own, where they are found on the processor: a software device
// spends more on a triangle that covers nothing than this does.
#pragma once

#include "gpu/buffer.h"
#include "passes/device_scene.h"
#include "scene/pixel_box.h"
#include "shaders/shared/frame.h"
#include "shaders/shared/instance.h"

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace torrance {

struct VisibleTriangles
{
    /// Of one instance.
    struct Range
    {
        std::uint32_t instance, firstIndex, indexCount;
    };
    gpu::Buffer indices;
    std::map<int, std::vector<Range>> draws; // by Draw::firstInstance, of those that are culled

    /// Null: all of its triangles are to be drawn.
    const std::vector<Range>* of(const Draw& draw) const
    {
        const auto found = draws.find(draw.firstInstance);
        return found == draws.end() ? nullptr : &found->second;
    }
};

/// Whether a draw's backs are left out as they are rasterized; its fronts are the other side where it is mirrored.
bool hidesBacks(const Batch& batch, const Draw& draw, const PixelBox& seen);

/// Finds them frame by frame, and keeps its memory in between: a software driver's new memory costs a page fault each 4
/// KiB.
class TriangleCulling
{
public:
    explicit TriangleCulling(const gpu::Device& d) : device(d) {}

    /// For the plan's draws that are to be culled, as a frame with these inputs places their instances (by
    /// ShadingPlan::instances). Null where there are none. Valid until the next call: what was drawn before must have
    /// ended by then.
    const VisibleTriangles* find(const DeviceScene& scene, const Camera& camera, const shared::Frame& frame,
                                 std::span<const shared::Instance> instances);

private:
    struct Work;
    std::vector<Work> workOf(const DeviceScene& scene, const Camera& camera, const shared::Frame& frame,
                             std::span<const shared::Instance> instances) const;

    const gpu::Device& device;
    std::vector<vec2> places;
    VisibleTriangles visible;
};

} // namespace torrance
