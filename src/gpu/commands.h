// One recording of work for the queue, waited for on the host. Passes name what they use; barriers follow from that.
#pragma once

#include "gpu/access.h"
#include "gpu/buffer.h"
#include "gpu/image.h"

#include <functional>
#include <initializer_list>
#include <map>
#include <vector>

namespace torrance::gpu {

class Commands
{
public:
    explicit Commands(const Device& device);
    /// What was recorded and not submitted did not happen: the histories of what it used are what they were.
    ~Commands();
    Commands(const Commands&) = delete;
    Commands& operator=(const Commands&) = delete;

    /// Records what must happen before the uses that follow.
    void use(std::span<const ImageUse> images, std::span<const BufferUse> buffers = {});
    void use(std::initializer_list<ImageUse> images) { use(std::span(images.begin(), images.size())); }
    void use(std::initializer_list<ImageUse> images, std::initializer_list<BufferUse> buffers)
    {
        use(std::span(images.begin(), images.size()), std::span(buffers.begin(), buffers.size()));
    }

    /// Ends the recording, runs it, waits. An Error (deviceFailure) where the device fails. May be called once.
    void submitAndWait();

    /// Ends the recording and runs it, not before `wait` and, with all that it does, before `signal` and the fence,
    /// which the caller waits for before this object goes. May be called once.
    void submit(const vk::raii::Semaphore& wait, const vk::raii::Semaphore& signal, const vk::raii::Fence& fence);

    const Device& device;

private:
    void end();
    std::map<AccessHistory*, AccessHistory> before; // of what was used so far; empty once it is submitted
    vk::raii::CommandPool pool;

public:
    vk::raii::CommandBuffer buffer;
};

ImageUse use(const DeviceImage& image, Access access, bool discard = false);
BufferUse use(const Buffer& buffer, Access access);

/// Copies tightly packed texels from a buffer into every (layer, mip) in the order mip-major: all layers of mip 0, then
/// mip 1 ... Leaves the image as `sampled`.
void copyToImage(Commands& commands, const Buffer& source, const DeviceImage& target, std::size_t bytesPerTexel);

/// Copies mip 0, layer 0 to a host-readable buffer, tightly packed.
void copyToBuffer(Commands& commands, const DeviceImage& source, const Buffer& target);

/// Copies mip 0, layer 0 to an image of the same size and format.
void copyImage(Commands& commands, const DeviceImage& source, const DeviceImage& target);

} // namespace torrance::gpu
