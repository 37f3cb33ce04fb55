#include "study/sphere_set.h"

#include "scene/primitive_bounds.h"
#include "study/analytic_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace torrance {
namespace {

constexpr double kCell = double(kSphereCell) / kSphereRadius; // side of a square; a sphere's radius is 1
constexpr double kCameraDistance = 10.0;
const dvec3 kBodyColor(0.6, 0.35, 0.2);

int columnsOf(const MethodGrid& grid)
{
    return static_cast<int>(grid.roughnesses.size());
}

int rowsOf(const MethodGrid& grid)
{
    return static_cast<int>(grid.reflectances.size());
}

bool isDielectric(std::size_t reflectance)
{
    return reflectance == 0;
}

dvec3 centerOf(const MethodGrid& grid, int column, int row)
{
    return {(column + 0.5 - 0.5 * columnsOf(grid)) * kCell, (0.5 * rowsOf(grid) - row - 0.5) * kCell, 0.0};
}

dmat4 movedTo(const dvec3& place)
{
    dmat4 transform(1.0);
    transform[3] = dvec4(place, 1.0);
    return transform;
}

std::vector<Material> materialsOf(const MethodGrid& grid, SphereBodies bodies)
{
    std::vector<Material> materials;
    for (std::size_t f = 0; f < grid.reflectances.size(); ++f)
        for (const double roughness : grid.roughnesses)
            materials.push_back(
                isDielectric(f) ? plainMaterial(bodies == SphereBodies::black ? dvec3(0.0) : kBodyColor, 0.0, roughness)
                                : plainMaterial(dvec3(grid.reflectances[f]), 1.0, roughness));
    return materials;
}

// Quads enough for a sphere of some pixels; u runs once round +Y, v from +Y to -Y.
Primitive ballMesh(int material)
{
    constexpr int kSegments = 48, kRings = 24;
    Primitive mesh;
    mesh.name = "ball";
    mesh.material = material;
    for (int j = 0; j <= kRings; ++j)
        for (int i = 0; i <= kSegments; ++i) {
            const double u = double(i) / kSegments, v = double(j) / kRings;
            const double around = 2.0 * kPi * u, down = kPi * v;
            const dvec3 n(std::sin(around) * std::sin(down), std::cos(down), std::cos(around) * std::sin(down));
            mesh.positions.emplace_back(n);
            mesh.normals.emplace_back(n);
            mesh.tangents.emplace_back(std::cos(around), 0.0, -std::sin(around), 1.0);
            mesh.uvs[0].emplace_back(u, v);
        }
    constexpr std::uint32_t kRow = kSegments + 1;
    for (std::uint32_t j = 0; j < kRings; ++j)
        for (std::uint32_t i = 0; i < kSegments; ++i) {
            const std::uint32_t a = j * kRow + i, b = a + kRow;
            mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
        }
    setBounds(mesh);
    return mesh;
}

// Waves in both directions of which several lie under a pixel of the set, steep enough to matter.
TextureImage bumpTexels()
{
    constexpr int kSide = 512, kWaves = 64;
    constexpr double kSlope = 0.35;
    TextureImage image;
    image.name = "bumps";
    image.width = image.height = kSide;
    image.texels.resize(std::size_t(kSide) * kSide * bytesPerTexel(TexelFormat::rgba8));
    const auto code = [](double x) {
        return std::byte(static_cast<unsigned char>(std::lround(255.0 * (0.5 + 0.5 * x))));
    };
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double phase = 2.0 * kPi * kWaves / kSide;
            const dvec3 n = glm::normalize(dvec3(kSlope * std::sin(phase * x), kSlope * std::sin(phase * y), 1.0));
            const std::byte codes[] = {code(n.x), code(n.y), code(n.z), std::byte(0xff)};
            std::memcpy(image.texels.data() + 4 * (std::size_t(y) * kSide + std::size_t(x)), codes, sizeof codes);
        }
    return image;
}

Light lamp(const dvec3& towards, double lux)
{
    return {.name = "lamp", .intensity = lux, .direction = -glm::normalize(towards)};
}

} // namespace

MethodGrid sphereGrid()
{
    return {.roughnesses = {0.05, 0.15, 0.25, 0.4, 0.55, 0.7, 0.85, 1.0},
            .reflectances = {0.04, 0.3, 0.6, 0.95},
            .cosines = {kLeastSphereCosine, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 1.0}};
}

std::optional<SpherePixel> spherePixel(const MethodGrid& grid, int x, int y)
{
    const int column = x / kSphereCell, row = y / kSphereCell;
    const double right = (x % kSphereCell + 0.5 - 0.5 * kSphereCell) / kSphereRadius;
    const double up = (0.5 * kSphereCell - y % kSphereCell - 0.5) / kSphereRadius;
    const double square = 1.0 - right * right - up * up;
    if (!(square >= kLeastSphereCosine * kLeastSphereCosine))
        return std::nullopt;
    SpherePixel pixel = {.reflectance = static_cast<std::size_t>(row),
                         .roughness = static_cast<std::size_t>(column),
                         .column = 0,
                         .normal = dvec3(right, up, std::sqrt(square))};
    while (pixel.column + 1 < grid.columns() && pixel.normal.z >= grid.cosines[pixel.column + 1])
        ++pixel.column;
    return pixel;
}

std::size_t sphereMaterial(const MethodGrid& grid, const SpherePixel& pixel)
{
    return pixel.reflectance * grid.roughnesses.size() + pixel.roughness;
}

Scene sphereSet(const MethodGrid& grid, SphereBodies bodies)
{
    Scene scene;
    scene.name = "spheres";
    scene.materials = materialsOf(grid, bodies);
    for (int row = 0; row < rowsOf(grid); ++row)
        for (int column = 0; column < columnsOf(grid); ++column)
            scene.shapes.push_back({.kind = AnalyticShape::Kind::sphere,
                                    .material = row * columnsOf(grid) + column,
                                    .worldFromObject = movedTo(centerOf(grid, column, row)),
                                    .name = "sphere"});
    return scene;
}

void addBumps(Scene& scene)
{
    scene.images.push_back(bumpTexels());
    scene.textures.push_back({.image = static_cast<int>(scene.images.size()) - 1, .sampler = {}});
    scene.materials.front().normal.texture = static_cast<int>(scene.textures.size()) - 1;
}

Scene bumpySphereSet(const MethodGrid& grid)
{
    Scene scene;
    scene.name = "bumpy spheres";
    scene.materials = materialsOf(grid, SphereBodies::colored);
    addBumps(scene);
    for (Material& material : scene.materials)
        material.normal = scene.materials.front().normal;
    for (int row = 0; row < rowsOf(grid); ++row)
        for (int column = 0; column < columnsOf(grid); ++column) {
            scene.instances.push_back({.primitive = static_cast<int>(scene.primitives.size()),
                                       .object = static_cast<int>(scene.primitives.size()),
                                       .worldFromObject = movedTo(centerOf(grid, column, row))});
            scene.primitives.push_back(ballMesh(row * columnsOf(grid) + column));
        }
    return scene;
}

Camera sphereCamera(const MethodGrid& grid)
{
    Camera camera;
    camera.kind = Camera::Kind::orthographic;
    camera.worldFromCamera = movedTo(dvec3(0.0, 0.0, kCameraDistance));
    camera.xmag = 0.5 * kCell * columnsOf(grid);
    camera.ymag = 0.5 * kCell * rowsOf(grid);
    camera.nearPlane = kCameraDistance - 2.0;
    camera.farPlane = kCameraDistance + 2.0;
    return camera;
}

Camera cellCamera(const MethodGrid& grid, int column, int row)
{
    Camera camera = sphereCamera(grid);
    camera.worldFromCamera = movedTo(centerOf(grid, column, row) + dvec3(0.0, 0.0, kCameraDistance));
    camera.xmag = camera.ymag = 0.5 * kCell;
    return camera;
}

Settings sphereSettings(const MethodGrid& grid, const brdf::Preset& methods)
{
    Settings settings;
    settings.methods = methods;
    settings.width = columnsOf(grid) * kSphereCell;
    settings.height = rowsOf(grid) * kSphereCell;
    settings.background = BackgroundKind::transparent;
    return settings;
}

std::vector<Light> sphereLamps()
{
    return {lamp({0.4, 0.5, 0.8}, 1.2),     lamp({-0.6, 0.3, 0.7}, 0.5), lamp({0.1, -0.7, 0.6}, 0.3),
            lamp({-0.95, -0.1, 0.25}, 0.6), lamp({0.9, -0.3, 0.2}, 0.4), lamp({0.2, 0.97, 0.1}, 0.6),
            lamp({-0.4, 0.6, -0.5}, 0.8)};
}

std::vector<Light> sphereAreaLights()
{
    const auto ball = [](const dvec3& place, double radius, double candela) {
        Light light = {.name = "ball", .kind = Light::Kind::point, .intensity = candela, .radius = radius};
        light.position = place;
        return light;
    };
    return {ball({-4.0, 5.0, 6.0}, 1.5, 110.0), ball({6.0, -3.0, 5.0}, 0.8, 50.0)};
}

} // namespace torrance
