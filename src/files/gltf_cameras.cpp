#include "files/gltf_cameras.h"

#include "files/gltf_model.h"

#include <cmath>

namespace torrance {
namespace {

/// Of a transform that may scale: rotation and translation. Nothing where two of its axes fall together.
bool setRigid(dmat4& rigid, const dmat4& world)
{
    const dvec3 back = glm::normalize(dvec3(world[2]));
    const dvec3 right = glm::normalize(glm::cross(dvec3(world[1]), back));
    const bool found = std::isfinite(glm::dot(back, back)) && std::isfinite(glm::dot(right, right));
    rigid = dmat4(1.0);
    if (found) {
        rigid[0] = dvec4(right, 0.0);
        rigid[1] = dvec4(glm::cross(back, right), 0.0);
        rigid[2] = dvec4(back, 0.0);
    }
    rigid[3] = world[3];
    return found;
}

void setPerspective(Camera& camera, const tinygltf::PerspectiveCamera& source, const std::string& item,
                    const LoadReport& report)
{
    if (!(source.yfov > 0.0 && source.yfov < kPi))
        report.fail(item, "has a yfov that is not between 0 and pi", "give it in radians");
    if (!(source.znear > 0.0) || source.zfar < 0.0 || (source.zfar > 0.0 && source.zfar <= source.znear))
        report.fail(item, "has planes that are not 0 < znear < zfar", kRepair);
    if (source.aspectRatio < 0.0)
        report.fail(item, "has a negative aspectRatio", "leave it out to take the picture's");
    camera.kind = Camera::Kind::perspective;
    camera.verticalFov = source.yfov;
    camera.aspect = source.aspectRatio;
    camera.nearPlane = source.znear;
    camera.farPlane = source.zfar;
}

void setOrthographic(Camera& camera, const tinygltf::OrthographicCamera& source, const std::string& item,
                     const LoadReport& report)
{
    if (source.xmag == 0.0 || source.ymag == 0.0)
        report.fail(item, "has an xmag or ymag of 0", kRepair);
    if (!(source.znear >= 0.0 && source.zfar > source.znear))
        report.fail(item, "has planes that are not 0 <= znear < zfar", kRepair);
    camera.kind = Camera::Kind::orthographic;
    camera.xmag = source.xmag;
    camera.ymag = source.ymag;
    camera.aspect = std::abs(source.xmag / source.ymag);
    camera.nearPlane = source.znear;
    camera.farPlane = source.zfar;
}

} // namespace

Camera readCamera(const tinygltf::Model& model, std::size_t index, const dmat4& world, LoadReport& report)
{
    const tinygltf::Camera& source = model.cameras[index];
    const std::string item = itemName("cameras", index);
    Camera camera;
    camera.name = source.name;
    if (source.type == "perspective")
        setPerspective(camera, source.perspective, item + "/perspective", report);
    else
        setOrthographic(camera, source.orthographic, item + "/orthographic", report);
    if (!setRigid(camera.worldFromCamera, world))
        report.warn(item, "stands on a node that has no rotation (scale 0): it looks along -Z");
    return camera;
}

} // namespace torrance
