// Which part of a picture a part of a scene can cover.
#pragma once

#include "math/box.h"
#include "scene/scene.h"

#include <span>
#include <vector>

namespace torrance {

struct PixelBox
{
    ivec2 first = ivec2(0);  // column and row
    ivec2 beyond = ivec2(0); // one after the last
    bool nearCut = false;    // it reaches behind the near plane, or to the eye: it may cover anything

    bool empty() const { return first.x >= beyond.x || first.y >= beyond.y; }
    void include(const PixelBox& box);
};

/// The side of the blocks in which devices shade: pixels of one share what they know of their neighbours (derivatives,
/// the levels of textures). lavapipe's are the largest known.
inline constexpr int kShadedBlock = 4;

/// The whole blocks of a picture that hold one of these pixels, each once, row by row.
std::vector<PixelBox> blocksAround(std::span<const ivec2> pixels, int width, int height);

/// The pixels of a picture that what lies in a box of the world may cover, samples up to a pixel off their centres
/// included; the whole picture where the box reaches behind the near plane.
PixelBox pixelBoxOf(const Camera& camera, int width, int height, const Box& box);

} // namespace torrance
