// What a picture is made from, as plain data: no reader, no device. Metres, glTF axes (+Y up, +Z towards the viewer of
// an asset's front), right-handed.
#pragma once

#include "image/image.h"
#include "math/vector.h"
#include "scene/material.h"
#include "scene/texture.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace torrance {

enum class Topology
{
    points,
    lines,     // pairs of indices: strips and loops are unrolled on loading
    triangles, // triples of indices: strips and fans are unrolled on loading
};

/// One glTF mesh primitive. Attributes are empty or have positions.size() elements.
struct Primitive
{
    std::string name; // mesh name and primitive number, for messages
    Topology topology = Topology::triangles;
    std::vector<vec3> positions;
    std::vector<vec3> normals;
    std::vector<vec4> tangents; // xyz unit, w = sign of the bitangent
    std::array<std::vector<vec2>, 2> uvs;
    std::vector<vec4> colors; // linear, multiplies base colour
    std::vector<std::uint32_t>
        indices;       // never empty for a primitive that is drawn: made 0..n-1 where the file has none
    int material = -1; // Scene::materials; -1 = glTF's default material
    dvec3 boundsMin = dvec3(0.0);
    dvec3 boundsMax = dvec3(0.0);
};

/// A shape whose surface is exact: no mesh error. Used where a picture is held against theory.
struct AnalyticShape
{
    enum class Kind
    {
        sphere, // about the origin, radius 1
        plane,  // z = 0, normal +Z, |x| and |y| at most 1
    };
    Kind kind = Kind::sphere;
    int material = -1;
    dmat4 worldFromObject = dmat4(1.0); // rotation, translation, uniform scale
    std::string name;
};

/// A primitive placed in the world.
struct Instance
{
    int primitive = 0;                  // Scene::primitives
    int object = 0;                     // number of the node that holds it, for object-id pictures
    dmat4 worldFromObject = dmat4(1.0); // may mirror, may be singular
};

struct Light
{
    enum class Kind
    {
        directional, // intensity in lux
        point,       // candela
        spot,        // candela
    };
    std::string name;
    Kind kind = Kind::directional;
    dvec3 color = dvec3(1.0); // linear
    double intensity = 1.0;
    double range = 0.0;  // metres, 0 = unlimited
    double radius = 0.0; // metres, point and spot: a sphere of even radiance intensity / (pi radius^2); 0 = a point
    double innerConeAngle = 0.0;             // radians
    double outerConeAngle = kPi / 4.0;       // radians
    dvec3 position = dvec3(0.0);             // world
    dvec3 direction = dvec3(0.0, 0.0, -1.0); // world, unit, the way the light travels

    bool operator==(const Light&) const = default;
};

struct Camera
{
    enum class Kind
    {
        perspective,
        orthographic,
    };
    std::string name;
    Kind kind = Kind::perspective;
    dmat4 worldFromCamera = dmat4(1.0); // rigid; looks along -Z, +Y up
    double verticalFov = 0.8;           // radians, perspective
    double aspect = 0.0;                // width / height asked for by the file, 0 = the picture's
    double xmag = 1.0;                  // half width and half height, orthographic
    double ymag = 1.0;
    double nearPlane = 0.01;
    double farPlane = 0.0; // 0 = infinite
};

/// A lat-long panorama. Direction (x, y, z) lies at column u = 0.5 + atan2(z, x) / 2 pi, row v = acos(y) / pi (top row
/// +Y).
struct Environment
{
    std::string name;
    Image radiance;         // 3 channels, width = 2 * height as a rule
    double rotation = 0.0;  // radians about +Y: the panorama is turned counter-clockwise seen from above
    double intensity = 1.0; // factor on the radiance
};

struct Scene
{
    std::string name;
    std::vector<Primitive> primitives;
    std::vector<Instance> instances;
    std::vector<AnalyticShape> shapes;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<TextureImage> images;
    std::vector<Light> lights;
    std::vector<Camera> cameras;
    std::optional<Environment> environment;
};

} // namespace torrance
