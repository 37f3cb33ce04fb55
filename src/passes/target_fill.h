// Targets of 16 bytes a pixel get their first content by copies where a processor draws: lavapipe (Mesa 22.3) clears
// them with a call of memcpy for each pixel, 8 ms of a processor for a target of 1024x1024, and copies rows in a third
// of that.
#pragma once

#include "passes/targets.h"

#include <cstdint>
#include <list>

namespace torrance {

class TargetFill
{
public:
    explicit TargetFill(const gpu::Device& d) : device(d) {}

    /// To be called before beginRendering with the same targets, which are of one size: records what fills them with
    /// the bits of `color` and says that they are kept, or, where the device clears by itself, returns `color`. A
    /// recording fills with kStrips colours at most; it is waited for before the next one begins.
    ClearColor fill(gpu::Commands& commands, std::span<const gpu::DeviceImage* const> targets, const ClearColor& color);

    static constexpr std::size_t kStrips = 2; // what lies behind the scene, and nothing

private:
    // Some rows of one colour.
    struct Strip
    {
        vec4 color;
        std::uint32_t width;
        std::uint32_t rows;
        gpu::Buffer texels;
    };
    const Strip& stripOf(const vec4& color, std::uint32_t width);

    const gpu::Device& device;
    std::list<Strip> strips; // the one that was used last comes first
};

} // namespace torrance
