// Barriers derived from what passes say that they read and write. The synchronization validation of 1.3.239 sees no
// hazard on attachments of dynamic rendering, so nobody writes a barrier by hand: this is the one place.
#pragma once

#include "gpu/vulkan.h"

#include <span>
#include <vector>

namespace torrance::gpu {

/// One way to use a resource in a pass.
enum class Access
{
    colorAttachment, // loaded, cleared, blended, stored
    depthAttachment, // tested and written
    depthTest,       // tested only, and read in a fragment shader
    sampled,         // read in a fragment shader
    shaderRead,      // uniform or storage buffer, vertex and fragment shaders
    vertexRead,      // vertex and index buffers
    transferRead,
    transferWrite,
    hostRead, // after the fence
    present,  // handed to the window system
};

struct AccessState
{
    vk::PipelineStageFlags2 stages;
    vk::AccessFlags2 access;
    vk::ImageLayout layout; // undefined for buffers
    bool writes;
};

AccessState stateOf(Access access);

/// What has been done with a resource: the last write and the reads since. Lives and dies with the resource, so that a
/// handle used again by the driver starts anew.
struct AccessHistory
{
    vk::PipelineStageFlags2 writeStages; // of the last write or change of layout
    vk::AccessFlags2 writeAccess;
    vk::PipelineStageFlags2 readStages; // since then
    vk::PipelineStageFlags2 visibleStages;
    vk::AccessFlags2 visibleAccess;
    vk::ImageLayout layout = vk::ImageLayout::eUndefined;
    /// The queue family that takes over, at the next change of layout, what others have filled the image with.
    std::uint32_t takenOverBy = VK_QUEUE_FAMILY_IGNORED;
};

/// What a pass does with one image or buffer (whole, all mips and layers).
struct ImageUse
{
    vk::Image image;
    vk::ImageAspectFlags aspect;
    AccessHistory* history;
    Access access;
    bool discard = false; // the old content is not needed: it may be thrown away
};

struct BufferUse
{
    vk::Buffer buffer;
    AccessHistory* history;
    Access access;
};

struct Barriers
{
    std::vector<vk::ImageMemoryBarrier2> images;
    std::vector<vk::BufferMemoryBarrier2> buffers;

    bool empty() const { return images.empty() && buffers.empty(); }
};

/// What must be waited for before the uses, which are then noted in the histories.
/// - read after write: wait for the write, make it visible; later reads in a stage that has seen it wait for nothing;
/// - write after read: wait for the reads, no memory to make visible;
/// - write after write: both;
/// - a change of layout is a write, and takes over what was there (AccessHistory::takenOverBy).
Barriers barriersBefore(std::span<const ImageUse> images, std::span<const BufferUse> buffers);

} // namespace torrance::gpu
