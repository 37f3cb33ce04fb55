#include "view/screen_place.h"

#include "scene/camera_view.h"

namespace torrance {
namespace {

dmat4 clipFromWorld(const Camera& camera, const ivec2& size)
{
    return projectionMatrix(camera, double(size.x) / size.y) * viewFromWorld(camera);
}

} // namespace

std::optional<dvec2> pixelOfPoint(const dvec3& point, const Camera& camera, const ivec2& pictureSize)
{
    const dvec4 clip = clipFromWorld(camera, pictureSize) * dvec4(point, 1.0);
    if (clip.z > clip.w || !(clip.w > 0.0)) // depth is reversed: 1 at the near plane
        return std::nullopt;
    return (dvec2(clip) / clip.w * 0.5 + 0.5) * dvec2(pictureSize);
}

dvec3 movedByPixels(const dvec3& point, const dvec2& pixels, const Camera& camera, const ivec2& pictureSize)
{
    const dmat4 toClip = clipFromWorld(camera, pictureSize);
    dvec4 clip = toClip * dvec4(point, 1.0);
    clip += dvec4(2.0 * pixels / dvec2(pictureSize) * clip.w, 0.0, 0.0);
    const dvec4 world = glm::inverse(toClip) * clip;
    return dvec3(world) / world.w;
}

} // namespace torrance
