// Which triangles of a mesh can show in a picture: whoever rasterizes on a processor finds that out faster than by
// drawing them. The tests are those that G. Wihlidal, "Optimizing the Graphics Pipeline with Compute" (GDC 2016), makes
// on a GPU: a triangle that shows its back, lies beside the picture, or lies between the centres of pixels.
#pragma once

#include "math/box.h"
#include "math/lanes.h"
#include "math/vector.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace torrance {

enum class VisibleSides
{
    both,
    counterClockwise, // as seen in the picture
    clockwise,
};

/// How one instance of a mesh comes to a picture with one sample in the middle of each pixel.
struct TriangleView
{
    mat4 clipFromObject; // to Vulkan's clip space
    vec2 halfSize;       // of the picture, in pixels
    VisibleSides sides;
    float leastW; // vertices whose W is less are nowhere
    float doubt;  // pixels: how far from each other the device and this may place a vertex, along each axis
};

/// What a device makes of a mesh's vertex p in floats: clipFromEye * (linear * p + translation, 1).
struct VertexTransform
{
    mat4 clipFromEye;
    mat3 linear;
    vec3 translation;
};

/// For a device that moves vertices to a grid of 2^-subpixelBits pixels. `box` holds the vertices. None where they may
/// lie behind the eye, or where rounding may move them by a good part of a pixel: then all must be drawn.
std::optional<TriangleView> triangleView(const VertexTransform& transform, const Box& box, const ivec2& pixels,
                                         VisibleSides sides, unsigned subpixelBits);

/// Where vertices lie in the picture, in pixels from its corner; NaN where a vertex is nowhere, or so far beside the
/// picture that its place is in doubt. One of `places` for each of `positions`.
void placeVertices(const TriangleView& view, std::span<const vec3> positions, std::span<vec2> places);

/// Copies the indices of the triangles that may cover the centre of a pixel, in their order; returns how many indices.
/// `kept` has room for all of them; without AVX2 they are the same. None that does is left out; some that do not are
/// kept: those too close to tell.
std::size_t keepVisible(const TriangleView& view, std::span<const std::uint32_t> indices, std::span<const vec2> places,
                        std::uint32_t* kept, bool avx2 = processorHasAvx2());

} // namespace torrance
