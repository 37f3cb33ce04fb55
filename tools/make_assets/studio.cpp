#include "make_assets/studio.h"

#include "make_assets/panorama.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace torrance::assets {
namespace {

/// A rectangular lamp that faces the origin.
struct SoftBox
{
    dvec3 centre;
    double halfWidth;
    double halfHeight;
    double rounding; // radius of the corners
    double softness; // width of the edge's falloff
    double vignette; // how much darker the corners are than the middle, 0 to 1
    dvec3 radiance;
};

const std::array<SoftBox, 4> kSoftBoxes = {{
    // The key light, large, left and in front, a little warm.
    {dvec3(-2.2, 1.7, 1.5), 1.25, 1.0, 0.12, 0.10, 0.35, dvec3(10.0, 9.6, 9.0)},
    // A tall strip on the right, which draws the edges of glossy things.
    {dvec3(2.6, 0.9, 0.5), 0.28, 1.5, 0.10, 0.07, 0.20, dvec3(9.5, 10.2, 11.2)},
    // The overhead scrim.
    {dvec3(0.1, 2.6, -0.4), 1.3, 0.8, 0.15, 0.30, 0.45, dvec3(5.2, 5.2, 5.2)},
    // A low strip behind on the left for the rims.
    {dvec3(-1.5, 0.9, -2.4), 0.22, 1.1, 0.08, 0.08, 0.20, dvec3(6.0, 5.6, 5.2)},
}};

double smoothStep(double low, double high, double x)
{
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The box's light along a direction: its rectangle is hit or it is not, with soft edges.
dvec3 softBoxRadiance(const SoftBox& box, const dvec3& direction)
{
    const double distance = glm::length(box.centre);
    const dvec3 axis = box.centre / distance;
    const double along = glm::dot(direction, axis);
    if (along <= 0.0)
        return dvec3(0.0);
    const dvec3 right = glm::normalize(glm::cross(dvec3(0.0, 1.0, 1e-3), axis));
    const dvec3 up = glm::cross(axis, right);
    const dvec3 hit = direction * (distance / along);
    const dvec2 place(glm::dot(hit, right), glm::dot(hit, up));

    // Signed distance to a rectangle with rounded corners, negative inside.
    const dvec2 corner = glm::abs(place) - dvec2(box.halfWidth, box.halfHeight) + box.rounding;
    const double edge =
        glm::length(glm::max(corner, dvec2(0.0))) + std::min(std::max(corner.x, corner.y), 0.0) - box.rounding;
    const dvec2 relative = place / dvec2(box.halfWidth, box.halfHeight);
    const double fade = 1.0 - box.vignette * std::min(1.0, 0.5 * glm::dot(relative, relative));
    return box.radiance * (fade * smoothStep(0.0, -box.softness, edge));
}

/// Walls that darken upwards, a warm floor that gives back some light, and a soft horizon between them.
dvec3 roomRadiance(const dvec3& direction)
{
    const double height = direction.y;
    const dvec3 wall = glm::mix(dvec3(0.62, 0.59, 0.56), dvec3(0.20, 0.20, 0.21), smoothStep(0.0, 0.9, height));
    const dvec3 floor = glm::mix(dvec3(0.60, 0.52, 0.44), dvec3(0.36, 0.30, 0.24), smoothStep(0.0, 0.9, -height));
    const dvec3 room = glm::mix(floor, wall, smoothStep(-0.12, 0.12, height));
    // The side that the camera stands on is the brighter one: polished metal that faces the camera mirrors it.
    return room * (0.85 + 0.4 * direction.z + 0.9 * std::max(direction.z, 0.0) * direction.z);
}

} // namespace

Image studioPanorama(int width, int height)
{
    Image image = panorama(width, height, 2, [](const dvec3& direction) {
        dvec3 radiance = roomRadiance(direction);
        for (const SoftBox& box : kSoftBoxes)
            radiance += softBoxRadiance(box, direction);
        return radiance;
    });
    const dvec3 white = whiteRadiance(image, glm::normalize(dvec3(0.0, 1.0, 1.0)));
    const auto scale = static_cast<float>(3.0 / (white.r + white.g + white.b));
    for (float& value : image.texels)
        value *= scale;
    return image;
}

} // namespace torrance::assets
