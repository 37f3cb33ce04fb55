#include "certified_scenes.h"

#include "math/scrambled_sequence.h"
#include "scene/camera_fit.h"
#include "scenes.h"
#include "study/picture_case.h"
#include "tests/panorama_of.h"

#include <algorithm>
#include <cmath>

namespace torrance::test {
namespace {

constexpr int kSide = 20;

/// A number in [0, 1) of a scene, by purpose.
double random(int index, std::uint64_t purpose)
{
    return double(hashNumbers({std::uint64_t(index), purpose}) >> 11) * 0x1p-53;
}

enum class Sky
{
    smooth,
    sun,
    windows,
    even,
};

dvec3 radianceOf(Sky sky, const dvec3& direction, int index)
{
    const dvec3 smooth = glm::mix(dvec3(0.3, 0.25, 0.2), dvec3(0.5, 0.7, 1.0), 0.5 + 0.5 * direction.y);
    const dvec3 towards = glm::normalize(dvec3(random(index, 1) - 0.5, 0.2 + random(index, 2), 0.5));
    switch (sky) {
    case Sky::smooth:
        return smooth;
    case Sky::sun:
        return smooth + (glm::dot(direction, towards) > 0.99 ? dvec3(40.0, 36.0, 30.0) : dvec3(0.0));
    case Sky::windows:
        return std::cos(6.0 * std::atan2(direction.z, direction.x)) > 0.7 && std::abs(direction.y - 0.3) < 0.2
                   ? dvec3(6.0, 5.5, 5.0)
                   : dvec3(0.05);
    case Sky::even:
        break;
    }
    return dvec3(0.4);
}

Material materialOf(int index, std::uint64_t number, double metallic)
{
    const dvec3 color(0.2 + 0.8 * random(index, 10 + number), 0.2 + 0.8 * random(index, 20 + number),
                      0.2 + 0.8 * random(index, 30 + number));
    return plainMaterial(color, metallic, 0.1 + 0.8 * random(index, 40 + number));
}

Scene threeSpheres(int index)
{
    Scene scene;
    for (int i = 0; i < 3; ++i) {
        scene.materials.push_back(materialOf(index, std::uint64_t(i), 0.5 * i));
        const double angle = 2.0 * kPi * i / 3.0;
        dmat4 place(0.6);
        place[3] = dvec4(std::cos(angle), std::sin(angle), 0.0, 1.0);
        scene.shapes.push_back({AnalyticShape::Kind::sphere, i, place, "sphere " + std::to_string(i)});
    }
    return scene;
}

/// The surfaces, and how the name calls them.
std::pair<Scene, std::string> surfacesOf(int index)
{
    switch (index % 5) {
    case 0:
        return {shapeScene(AnalyticShape::Kind::sphere, materialOf(index, 0, 1.0)), "metal sphere"};
    case 1:
        return {shapeScene(AnalyticShape::Kind::sphere, materialOf(index, 0, 0.0)), "dielectric sphere"};
    case 2:
        return {shapeScene(AnalyticShape::Kind::plane, materialOf(index, 0, 1.0)), "metal square"};
    case 3:
        return {threeSpheres(index), "three spheres"};
    default:
        return {texturedTorus(), "textured torus"};
    }
}

} // namespace

CertifiedScene certifiedScene(int index)
{
    constexpr const char* kSkies[] = {"smooth sky", "sky with a sun", "windows", "even sky and a lamp"};
    const int sky = index % 4;
    auto [scene, surfaces] = surfacesOf(index);
    scene.environment = panoramaOf([&](const dvec3& d) { return radianceOf(static_cast<Sky>(sky), d, index); }, 64);
    if (static_cast<Sky>(sky) == Sky::even)
        scene.lights.push_back(testLight(Light::Kind::point));
    const Camera camera = fitCamera(scene, {0.7 * random(index, 3), 1.1 + 0.3 * random(index, 4)}, 1.0, 0.7, 0.05);
    Settings settings = squareSettings(*brdf::findPreset(index % 2 == 0 ? "standard" : "gltf"), kSide);
    settings.samples = index % 7 == 6 ? 4 : 1;
    const std::string filtered = settings.samples > 1 ? ", 4 samples" : "";
    return {surfaces + ", " + kSkies[sky] + filtered, std::move(scene), camera, settings};
}

} // namespace torrance::test
