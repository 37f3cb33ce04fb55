#include "study/growth_scenes.h"

#include "scene/camera_fit.h"
#include "scene/primitive_bounds.h"
#include "scene/shape_mesh.h"
#include "study/analytic_scenes.h"

#include <array>
#include <cmath>
#include <cstring>

namespace torrance {
namespace {

Light sun()
{
    return {.name = "sun", .intensity = 3.0, .direction = glm::normalize(dvec3(-0.4, -0.8, -0.5))};
}

Scene sceneOf(Primitive mesh, const Material& material)
{
    Scene scene;
    scene.name = mesh.name;
    scene.materials.push_back(material);
    mesh.material = 0;
    scene.primitives.push_back(std::move(mesh));
    scene.instances.push_back({});
    return scene;
}

// z = 1 - (x^2 + y^2) / 2 over the square of half side 1, as side x side quads.
Primitive domeMesh(int side)
{
    Primitive mesh;
    mesh.name = "dome";
    for (int j = 0; j <= side; ++j)
        for (int i = 0; i <= side; ++i) {
            const double x = 2.0 * i / side - 1.0, y = 2.0 * j / side - 1.0;
            mesh.positions.emplace_back(dvec3(x, y, 1.0 - 0.5 * (x * x + y * y)));
            mesh.normals.emplace_back(glm::normalize(dvec3(x, y, 1.0)));
        }
    const auto row = static_cast<std::uint32_t>(side + 1);
    for (std::uint32_t j = 0; j + 1 < row; ++j)
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = j * row + i, b = a + row;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
        }
    setBounds(mesh);
    return mesh;
}

Scene trianglesScene(double size)
{
    Scene scene = sceneOf(domeMesh(static_cast<int>(std::lround(std::sqrt(size / 2.0)))),
                          plainMaterial(dvec3(0.8, 0.5, 0.3), 0.2, 0.5));
    scene.lights.push_back(sun());
    return scene;
}

// On a ring, above the equator, none of them within the sphere; together as bright at any number.
Scene lightsScene(double size)
{
    Scene scene = sceneOf(sphereMesh(), plainMaterial(dvec3(0.7, 0.7, 0.6), 0.0, 0.4));
    const int count = static_cast<int>(size);
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * kPi * i / count;
        scene.lights.push_back({.name = "light",
                                .kind = Light::Kind::point,
                                .intensity = 30.0 / count,
                                .position = dvec3(3.0 * std::cos(angle), 2.0, 3.0 * std::sin(angle))});
    }
    return scene;
}

// No two neighbours alike, so that the map is not taken for a constant; opaque.
TextureImage noiseTexels(int side)
{
    TextureImage image;
    image.name = "noise";
    image.width = side;
    image.height = side;
    image.texels.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) *
                        bytesPerTexel(TexelFormat::rgba8));
    std::uint32_t state = 1;
    for (std::size_t i = 0; i < image.texels.size(); i += bytesPerTexel(TexelFormat::rgba8)) {
        state = state * 1664525u + 1013904223u; // Numerical Recipes' generator: its high bytes are good enough to see
        const std::array codes = {std::byte(state >> 24), std::byte(state >> 16), std::byte(state >> 8),
                                  std::byte(0xff)};
        std::memcpy(image.texels.data() + i, codes.data(), codes.size());
    }
    return image;
}

Scene texelsScene(double size)
{
    Material material = plainMaterial(dvec3(1.0), 0.0, 0.5);
    material.baseColor.texture = 0;
    Scene scene = sceneOf(planeMesh(), material);
    scene.images.push_back(noiseTexels(static_cast<int>(std::lround(std::sqrt(size)))));
    scene.textures.push_back({.image = 0, .sampler = {}});
    scene.lights.push_back(sun());
    return scene;
}

Scene pixelsScene(double)
{
    Scene scene = sceneOf(sphereMesh(), plainMaterial(dvec3(0.8, 0.5, 0.3), 0.2, 0.5));
    scene.lights.push_back(sun());
    return scene;
}

void setPixels(double size, Settings& settings)
{
    settings.width = settings.height = static_cast<int>(std::lround(std::sqrt(size)));
}

// In rows in the plane of the picture, half of which they cover at any number.
Scene instancesScene(double size)
{
    Scene scene = sceneOf(cubeMesh(), plainMaterial(dvec3(0.3, 0.5, 0.8), 0.0, 0.5));
    scene.lights.push_back(sun());
    scene.instances.clear();
    const int count = static_cast<int>(size), row = static_cast<int>(std::ceil(std::sqrt(size)));
    for (int i = 0; i < count; ++i) {
        dmat4 place(0.35 / row * 2.0);
        place[3] = dvec4((2.0 * (i % row) + 1.0) / row - 1.0, (2.0 * (i / row) + 1.0) / row - 1.0, 0.0, 1.0);
        scene.instances.push_back({.primitive = 0, .object = i, .worldFromObject = place});
    }
    return scene;
}

std::vector<double> geometric(double first, double ratio, int count)
{
    std::vector<double> sizes;
    for (double size = first; count > 0; --count, size *= ratio)
        sizes.push_back(size);
    return sizes;
}

} // namespace

std::span<const GrowthSeries> growthSeries()
{
    static const std::vector<GrowthSeries> all = {
        {"triangles", "triangle", geometric(2.0 * 64 * 64, 4.0, 6), trianglesScene},
        {"lights", "light", geometric(1.0, 4.0, 5), lightsScene},
        {"texels", "texel", geometric(512.0 * 512.0, 4.0, 5), texelsScene},
        {"pixels", "pixel", geometric(256.0 * 256.0, 4.0, 6), pixelsScene, setPixels},
        {"instances", "instance", geometric(10.0, 10.0, 5), instancesScene}};
    return all;
}

Camera growthCamera(const Scene& scene)
{
    return fitCamera(scene, {.theta = kPi / 6.0, .phi = 75.0 / 180.0 * kPi}, 1.0, kPi / 4.0, 0.1);
}

} // namespace torrance
