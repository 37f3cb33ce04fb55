#include "scene/pixel_box.h"

#include "scene/camera_view.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace torrance {
namespace {

// Samples lie within half a pixel of the centre, and rounding to float moves a vertex by far less than the rest.
constexpr double kMargin = 1.0;

int clampedToInt(double value, int greatest)
{
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(greatest)));
}

} // namespace

void PixelBox::include(const PixelBox& box)
{
    nearCut |= box.nearCut;
    if (box.empty())
        return;
    if (empty()) {
        first = box.first;
        beyond = box.beyond;
        return;
    }
    first = glm::min(first, box.first);
    beyond = glm::max(beyond, box.beyond);
}

PixelBox pixelBoxOf(const Camera& camera, int width, int height, const Box& box)
{
    if (box.empty())
        return {};
    const dmat4 view = viewFromWorld(camera);
    const dmat4 projection = projectionMatrix(camera, static_cast<double>(width) / height);
    const dvec3 eye = cameraPosition(camera);
    dvec2 least(std::numeric_limits<double>::infinity()), greatest(-std::numeric_limits<double>::infinity());
    for (int i = 0; i < 8; ++i) {
        const dvec4 seen = view * dvec4(box.corner(i) - eye, 0.0); // relative to the eye: no large numbers to cancel
        if (!(-seen.z > camera.nearPlane))
            return {.first = ivec2(0), .beyond = {width, height}, .nearCut = true};
        const dvec4 clip = projection * dvec4(dvec3(seen), 1.0);
        const dvec2 pixel =
            0.5 * (dvec2(clip) / clip.w + 1.0) * dvec2(static_cast<double>(width), static_cast<double>(height));
        least = glm::min(least, pixel);
        greatest = glm::max(greatest, pixel);
    }
    return {.first = {clampedToInt(std::floor(least.x - kMargin), width),
                      clampedToInt(std::floor(least.y - kMargin), height)},
            .beyond = {clampedToInt(std::ceil(greatest.x + kMargin), width),
                       clampedToInt(std::ceil(greatest.y + kMargin), height)}};
}

std::vector<PixelBox> blocksAround(std::span<const ivec2> pixels, int width, int height)
{
    std::set<std::pair<int, int>> blocks; // row and column
    for (const ivec2& pixel : pixels)
        blocks.emplace(pixel.y / kShadedBlock, pixel.x / kShadedBlock);
    std::vector<PixelBox> boxes;
    for (const auto& [row, column] : blocks) {
        const ivec2 first(column * kShadedBlock, row * kShadedBlock);
        boxes.push_back({first, glm::min(first + kShadedBlock, ivec2(width, height))});
    }
    return boxes;
}

} // namespace torrance
