#include "view/selection_box.h"

#include "scene/camera_view.h"

#include <array>
#include <optional>

namespace torrance {
namespace {

// Clip space with reversed depth: a point is in front of the near plane where z <= w.
std::optional<ScreenLine> lineOf(dvec4 a, dvec4 b, const ivec2& size)
{
    const double beforeA = a.w - a.z, beforeB = b.w - b.z;
    if (beforeA < 0.0 && beforeB < 0.0)
        return std::nullopt;
    if (beforeA < 0.0)
        a += (b - a) * (beforeA / (beforeA - beforeB));
    else if (beforeB < 0.0)
        b += (a - b) * (beforeB / (beforeB - beforeA));
    const auto pixel = [&](const dvec4& p) { return (dvec2(p) / p.w * 0.5 + 0.5) * dvec2(size); };
    return ScreenLine{pixel(a), pixel(b)};
}

} // namespace

std::vector<ScreenLine> selectionBox(const Scene& scene, int index, const Camera& camera, const ivec2& pictureSize)
{
    const Instance& instance = scene.instances[static_cast<std::size_t>(index)];
    const Primitive& primitive = scene.primitives[static_cast<std::size_t>(instance.primitive)];
    const dmat4 clipFromObject = projectionMatrix(camera, double(pictureSize.x) / pictureSize.y) *
                                 viewFromWorld(camera) * instance.worldFromObject;
    std::array<dvec4, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) {
        dvec3 corner = primitive.boundsMin;
        for (int axis = 0; axis < 3; ++axis)
            if (i >> axis & 1)
                corner[axis] = primitive.boundsMax[axis];
        corners[i] = clipFromObject * dvec4(corner, 1.0);
    }
    std::vector<ScreenLine> lines;
    for (std::size_t i = 0; i < 8; ++i)
        for (std::size_t axis = 1; axis < 8; axis <<= 1)
            if (!(i & axis))
                if (const auto line = lineOf(corners[i], corners[i | axis], pictureSize))
                    lines.push_back(*line);
    return lines;
}

} // namespace torrance
