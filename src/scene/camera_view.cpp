#include "scene/camera_view.h"

#include <cassert>
#include <cmath>

namespace torrance {
namespace {

/// The camera's axes in the world, orthonormal. Where the matrix is singular, an axis is chosen, so that the result is
/// always a rotation.
dmat3 cameraAxes(const Camera& camera)
{
    const dmat3 m(camera.worldFromCamera);
    const auto unitOr = [](const dvec3& v, const dvec3& fallback) {
        const double length = glm::length(v);
        return length > 0.0 && std::isfinite(length) ? v / length : fallback;
    };
    const dvec3 back = unitOr(m[2], dvec3(0, 0, 1));
    const dvec3 beside = std::abs(back.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
    const dvec3 right = unitOr(glm::cross(unitOr(m[1], beside), back), glm::normalize(glm::cross(beside, back)));
    return dmat3(right, glm::cross(back, right), back);
}

} // namespace

dvec3 cameraPosition(const Camera& camera)
{
    return dvec3(camera.worldFromCamera[3]);
}

dmat4 viewFromWorld(const Camera& camera)
{
    const dmat3 rotation = glm::transpose(cameraAxes(camera));
    dmat4 view(rotation);
    view[3] = dvec4(-(rotation * cameraPosition(camera)), 1.0);
    return view;
}

dmat4 projectionMatrix(const Camera& camera, double aspect)
{
    const double n = camera.nearPlane;
    const double f = camera.farPlane;
    assert(aspect > 0.0 && (f > n || (f == 0.0 && camera.kind == Camera::Kind::perspective)));

    dmat4 clip(0.0);
    if (camera.kind == Camera::Kind::orthographic) {
        clip[0][0] = 1.0 / (camera.ymag * aspect);
        clip[1][1] = -1.0 / camera.ymag;
        clip[2][2] = 1.0 / (f - n);
        clip[3][2] = f / (f - n);
        clip[3][3] = 1.0;
        return clip;
    }
    const double cotangent = 1.0 / std::tan(0.5 * camera.verticalFov);
    clip[0][0] = cotangent / aspect;
    clip[1][1] = -cotangent;
    clip[2][2] = f > 0.0 ? n / (f - n) : 0.0;
    clip[3][2] = f > 0.0 ? n * f / (f - n) : n;
    clip[2][3] = -1.0;
    return clip;
}

Ray primaryRay(const Camera& camera, int width, int height, double x, double y)
{
    const dmat3 axes = cameraAxes(camera);
    const double aspect = static_cast<double>(width) / height;
    const dvec2 ndc(2.0 * x / width - 1.0, 1.0 - 2.0 * y / height); // y up
    if (camera.kind == Camera::Kind::orthographic)
        return {axes * dvec3(ndc.x * camera.ymag * aspect, ndc.y * camera.ymag, 0.0), -axes[2]};
    const double tangent = std::tan(0.5 * camera.verticalFov);
    return {dvec3(0.0), glm::normalize(axes * dvec3(ndc.x * tangent * aspect, ndc.y * tangent, -1.0))};
}

} // namespace torrance
