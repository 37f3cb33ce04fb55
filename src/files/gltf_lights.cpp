#include "files/gltf_lights.h"

#include "files/gltf_model.h"

namespace torrance {
namespace {

/// pi/2 written with a few digits, as files have it, may be above it by this much.
constexpr double kAngleTolerance = 1e-4;

Light::Kind kindOf(const std::string& type, const std::string& item, const LoadReport& report)
{
    if (type == "directional")
        return Light::Kind::directional;
    if (type == "point")
        return Light::Kind::point;
    if (type == "spot")
        return Light::Kind::spot;
    report.fail(item, "has the unknown type \"" + type + "\"", "use directional, point or spot");
}

double atLeastZero(double value, const std::string& item, LoadReport& report)
{
    if (value >= 0.0)
        return value;
    report.warn(item, "is negative and was set to 0");
    return 0.0;
}

/// extras.radius of a point or spot light: glTF itself gives lights no size.
double radiusOf(const tinygltf::Light& source, Light::Kind kind, const std::string& item, LoadReport& report)
{
    if (!source.extras.IsObject() || !source.extras.Has("radius"))
        return 0.0;
    if (kind == Light::Kind::directional) {
        report.warn(item + "/extras/radius", "is of a directional light, which has no place, and was left out");
        return 0.0;
    }
    const double radius = source.extras.Get("radius").GetNumberAsDouble();
    if (!(radius >= 0.0))
        report.fail(item + "/extras/radius", "is below zero", "give a length in metres, or leave it out for a point");
    return radius;
}

void setCone(Light& light, const tinygltf::SpotLight& spot, const std::string& item, const LoadReport& report)
{
    const bool ordered = spot.innerConeAngle >= 0.0 && spot.innerConeAngle < spot.outerConeAngle;
    if (!ordered || spot.outerConeAngle > kPi / 2.0 + kAngleTolerance)
        report.fail(item + "/spot", "has cone angles that are not 0 <= inner < outer <= pi/2", kRepair);
    light.innerConeAngle = spot.innerConeAngle;
    light.outerConeAngle = std::min(spot.outerConeAngle, kPi / 2.0);
}

} // namespace

Light readLight(const tinygltf::Model& model, std::size_t index, const dmat4& world, LoadReport& report)
{
    const tinygltf::Light& source = model.lights[index];
    const std::string item = itemName("extensions/KHR_lights_punctual/lights", index);
    Light light;
    light.name = source.name;
    light.kind = kindOf(source.type, item, report);
    for (std::size_t i = 0; i < source.color.size(); ++i)
        light.color[static_cast<int>(i)] = atLeastZero(source.color[i], item + "/color", report);
    light.intensity = atLeastZero(source.intensity, item + "/intensity", report);
    if (source.range < 0.0)
        report.fail(item + "/range", "is not above zero", "leave it out for an unlimited range");
    light.range = source.range;
    light.radius = radiusOf(source, light.kind, item, report);
    if (light.kind == Light::Kind::spot)
        setCone(light, source.spot, item, report);

    light.position = dvec3(world[3]);
    const dvec3 direction = -dvec3(world[2]);
    const double length = glm::length(direction);
    if (length > 0.0)
        light.direction = direction / length;
    else if (light.kind != Light::Kind::point)
        report.warn(item, "stands on a node of scale 0 and shines along -Z");
    return light;
}

} // namespace torrance
