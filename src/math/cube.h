// Cube maps as Vulkan lays them out (Vulkan 1.3, section 16.5.4): faces +X -X +Y -Y +Z -Z; on a face, (a, b) in [-1, 1]
// grows to the right and downwards as the face is stored.
#pragma once

#include "math/vector.h"

#include <cmath>

namespace torrance {

inline constexpr int kCubeFaces = 6;

struct CubePoint
{
    int face = 0;
    double a = 0.0;
    double b = 0.0;
};

/// Not normalised: the component along the face's axis is 1 or -1.
inline dvec3 cubeVector(int face, double a, double b)
{
    switch (face) {
    case 0:
        return {1.0, -b, -a};
    case 1:
        return {-1.0, -b, a};
    case 2:
        return {a, 1.0, b};
    case 3:
        return {a, -1.0, -b};
    case 4:
        return {a, -b, 1.0};
    default:
        return {-a, -b, -1.0};
    }
}

/// The face that d (any length but 0) points through, and where. On an edge z wins over y, y over x, as the
/// specification recommends.
inline CubePoint cubePoint(const dvec3& d)
{
    const dvec3 size(std::abs(d.x), std::abs(d.y), std::abs(d.z));
    if (size.z >= size.x && size.z >= size.y)
        return d.z < 0.0 ? CubePoint{5, -d.x / size.z, -d.y / size.z} : CubePoint{4, d.x / size.z, -d.y / size.z};
    if (size.y >= size.x)
        return d.y < 0.0 ? CubePoint{3, d.x / size.y, -d.z / size.y} : CubePoint{2, d.x / size.y, d.z / size.y};
    return d.x < 0.0 ? CubePoint{1, d.z / size.x, -d.y / size.x} : CubePoint{0, -d.z / size.x, -d.y / size.x};
}

/// Face coordinate of the centre of texel i on a face of `size` texels.
inline double cubeTexelCentre(int i, int size)
{
    return (2.0 * i + 1.0) / size - 1.0;
}

/// Unit direction of the centre of a texel.
inline dvec3 cubeTexelDirection(int face, int x, int y, int size)
{
    return glm::normalize(cubeVector(face, cubeTexelCentre(x, size), cubeTexelCentre(y, size)));
}

/// Solid angle (sr) of the rectangle [a0, a1] x [b0, b1] of a face: the mixed antiderivative of (1 + a^2 + b^2)^(-3/2)
/// is atan(ab / sqrt(1 + a^2 + b^2)).
inline double cubeRectangleSolidAngle(double a0, double b0, double a1, double b1)
{
    const auto corner = [](double a, double b) { return std::atan2(a * b, std::sqrt(1.0 + a * a + b * b)); };
    return (corner(a1, b1) - corner(a0, b1)) - (corner(a1, b0) - corner(a0, b0));
}

/// Solid angle (sr) of a texel; all texels of the six faces add up to 4 pi.
inline double cubeTexelSolidAngle(int x, int y, int size)
{
    const auto edge = [&](int i) { return 2.0 * i / size - 1.0; };
    return cubeRectangleSolidAngle(edge(x), edge(y), edge(x + 1), edge(y + 1));
}

} // namespace torrance
