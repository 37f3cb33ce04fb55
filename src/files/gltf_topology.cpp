#include "files/gltf_topology.h"

namespace torrance {
namespace {

enum Mode : int
{
    points,
    lines,
    lineLoop,
    lineStrip,
    triangles,
    triangleStrip,
    triangleFan,
};

} // namespace

Topology topologyOfMode(int mode)
{
    if (mode == points)
        return Topology::points;
    return mode < triangles ? Topology::lines : Topology::triangles;
}

std::size_t unrolledCount(int mode, std::size_t count)
{
    switch (mode) {
    case points:
        return count;
    case lines:
        return count / 2 * 2;
    case lineLoop:
        return count < 2 ? 0 : 2 * count;
    case lineStrip:
        return count < 2 ? 0 : 2 * (count - 1);
    case triangles:
        return count / 3 * 3;
    default:
        return count < 3 ? 0 : 3 * (count - 2);
    }
}

std::vector<std::uint32_t> unrolled(int mode, std::vector<std::uint32_t> indices)
{
    const std::size_t count = unrolledCount(mode, indices.size());
    if (mode == points || mode == lines || mode == triangles) {
        indices.resize(count);
        return indices;
    }
    std::vector<std::uint32_t> list;
    list.reserve(count);
    const std::size_t perShape = mode < triangles ? 2 : 3;
    for (std::size_t i = 0; i < count / perShape; ++i)
        switch (mode) {
        case lineLoop:
        case lineStrip:
            list.insert(list.end(), {indices[i], indices[(i + 1) % indices.size()]});
            break;
        case triangleStrip:
            list.insert(list.end(), {indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]});
            break;
        default:
            list.insert(list.end(), {indices[i + 1], indices[i + 2], indices[0]});
        }
    return list;
}

} // namespace torrance
