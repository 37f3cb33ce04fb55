// Which part of a picture a part of a scene can cover.
#pragma once

#include "math/box.h"
#include "scene/scene.h"

namespace torrance {

struct PixelBox
{
    ivec2 first = ivec2(0);  // column and row
    ivec2 beyond = ivec2(0); // one after the last
    bool nearCut = false;    // it reaches behind the near plane, or to the eye: it may cover anything

    bool empty() const { return first.x >= beyond.x || first.y >= beyond.y; }
    void include(const PixelBox& box);
};

/// The pixels of a picture that what lies in a box of the world may cover, samples up to a pixel off their centres
/// included; the whole picture where the box reaches behind the near plane.
PixelBox pixelBoxOf(const Camera& camera, int width, int height, const Box& box);

} // namespace torrance
