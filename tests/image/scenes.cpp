#include "scenes.h"

#include "core/data_folder.h"
#include "files/environment_file.h"
#include "files/scene_file.h"
#include "scene/camera_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace torrance::test {
namespace {

void storeTexel(TextureImage& image, const dvec4& value)
{
    for (int c = 0; c < 4; ++c) {
        const double clamped = std::clamp(value[c], 0.0, 1.0);
        if (image.format == TexelFormat::rgba8) {
            image.texels.push_back(static_cast<std::byte>(std::lround(clamped * 255.0)));
            continue;
        }
        const auto code = static_cast<std::uint16_t>(std::lround(clamped * 65535.0));
        std::byte bytes[sizeof code];
        std::memcpy(bytes, &code, sizeof code);
        image.texels.insert(image.texels.end(), std::begin(bytes), std::end(bytes));
    }
}

/// A smooth periodic function of the texel, in [0, 1].
double wave(int x, int y, int size, int fx, int fy, double phase)
{
    return 0.5 + 0.5 * std::sin(2.0 * kPi * (fx * x + fy * y) / size + phase);
}

constexpr int kTorusTexels = 32;

TextureImage torusTexels(const std::function<dvec4(int, int)>& value)
{
    return makeTexels(kTorusTexels, kTorusTexels, TexelFormat::rgba8, value);
}

dvec4 torusNormalTexel(int x, int y)
{
    const dvec3 n = glm::normalize(dvec3(0.5 * wave(x, y, kTorusTexels, 2, 1, 0.3) - 0.25,
                                         0.5 * wave(x, y, kTorusTexels, 1, -2, 1.1) - 0.25, 1.0));
    return dvec4(0.5 * n + 0.5, 1.0);
}

Primitive torusMesh()
{
    constexpr int kAround = 64;
    constexpr int kAcross = 32;
    constexpr double kTube = 0.4;
    Primitive p;
    for (int j = 0; j <= kAcross; ++j)
        for (int i = 0; i <= kAround; ++i) {
            const double u = 2.0 * kPi * i / kAround;
            const double v = 2.0 * kPi * j / kAcross;
            const dvec3 normal(std::cos(v) * std::cos(u), std::sin(v), std::cos(v) * std::sin(u));
            const dvec3 tangent(-std::sin(u), 0.0, std::cos(u));
            p.positions.emplace_back(dvec3(std::cos(u), 0.0, std::sin(u)) + kTube * normal);
            p.normals.emplace_back(normal);
            // at u = v = 0 cross(normal, tangent) = -Y while the texture's v grows along +Y: against v, as w = 1 means
            p.tangents.emplace_back(dvec4(tangent, 1.0));
            p.uvs[0].emplace_back(4.0 * i / kAround, 2.0 * j / kAcross);
        }
    for (std::uint32_t j = 0; j < kAcross; ++j)
        for (std::uint32_t i = 0; i < kAround; ++i) {
            const std::uint32_t a = j * (kAround + 1) + i;
            const std::uint32_t b = a + kAround + 1;
            p.indices.insert(p.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    return p;
}

} // namespace

Scene maskedHalf(int size, double place)
{
    Scene scene;
    Material material = plainMaterial(dvec3(1.0), 0.0, 1.0);
    material.unlit = true;
    material.alphaMode = AlphaMode::mask;
    material.baseColor.texture = addTexture(
        scene,
        makeTexels(2, 1, TexelFormat::rgba8, [](int x, int) { return dvec4(1.0, 1.0, 1.0, x == 0 ? 1.0 : 0.0); }),
        levelZero(Filter::nearest, Wrap::clampToEdge));
    scene.materials.push_back(material);
    addInstance(scene, square(0), translation(dvec3(2.0 * place / size, 0, 0)));
    return scene;
}

Camera maskedHalfCamera()
{
    Camera camera = orbitCamera({}, 3.0, dvec3(0), 0.8);
    camera.kind = Camera::Kind::orthographic;
    camera.ymag = 1.0;
    camera.nearPlane = 0.1;
    camera.farPlane = 10.0;
    return camera;
}

dvec3 glow(const dvec3& d)
{
    const double lamp = std::exp(4.0 * (glm::dot(d, glm::normalize(dvec3(0.5, 0.7, 0.4))) - 1.0));
    return dvec3(0.3 + 3.0 * lamp, 0.5 + 2.0 * lamp + 0.2 * d.x, 0.8 + 0.3 * d.y * d.z);
}

dmat4 translation(const dvec3& offset)
{
    dmat4 m(1.0);
    m[3] = dvec4(offset, 1.0);
    return m;
}

TextureImage makeTexels(int width, int height, TexelFormat format, const std::function<dvec4(int, int)>& value)
{
    TextureImage image;
    image.name = "generated";
    image.width = width;
    image.height = height;
    image.format = format;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            storeTexel(image, value(x, y));
    return image;
}

int addTexture(Scene& scene, TextureImage image, const Sampler& sampler)
{
    scene.images.push_back(std::move(image));
    scene.textures.push_back({static_cast<int>(scene.images.size()) - 1, sampler});
    return static_cast<int>(scene.textures.size()) - 1;
}

Sampler levelZero(Filter filter, Wrap wrap)
{
    return {.wrapS = wrap, .wrapT = wrap, .magnify = filter, .minify = filter, .mip = MipFilter::none};
}

Primitive square(int material)
{
    Primitive p;
    p.name = "square";
    p.positions = {vec3(-1, -1, 0), vec3(1, -1, 0), vec3(1, 1, 0), vec3(-1, 1, 0)};
    p.normals.assign(4, vec3(0, 0, 1));
    p.tangents.assign(4, vec4(1, 0, 0, 1));
    p.uvs[0] = {vec2(0, 1), vec2(1, 1), vec2(1, 0), vec2(0, 0)};
    p.indices = {0, 1, 2, 0, 2, 3};
    p.material = material;
    return p;
}

int addInstance(Scene& scene, Primitive primitive, const dmat4& worldFromObject)
{
    primitive.boundsMin = dvec3(primitive.positions.at(0));
    primitive.boundsMax = primitive.boundsMin;
    for (const vec3& p : primitive.positions) {
        primitive.boundsMin = glm::min(primitive.boundsMin, dvec3(p));
        primitive.boundsMax = glm::max(primitive.boundsMax, dvec3(p));
    }
    scene.primitives.push_back(std::move(primitive));
    const int number = static_cast<int>(scene.instances.size());
    scene.instances.push_back({.primitive = static_cast<int>(scene.primitives.size()) - 1,
                               .object = number,
                               .worldFromObject = worldFromObject});
    return number;
}

Scene texturedTorus()
{
    Scene scene;
    const Sampler sampler = levelZero(Filter::linear);
    constexpr int n = kTorusTexels;
    Material m = plainMaterial(dvec3(0.9, 0.95, 1.0), 0.8, 0.9);
    m.baseColor.texture =
        addTexture(scene, torusTexels([](int x, int y) {
                       return dvec4(wave(x, y, n, 1, 2, 0.0), wave(x, y, n, 3, -1, 0.7), wave(x, y, n, 1, 1, 2.0), 1.0);
                   }),
                   sampler);
    m.metallicRoughness.texture =
        addTexture(scene, torusTexels([](int x, int y) {
                       return dvec4(0.0, 0.3 + 0.6 * wave(x, y, n, 2, 2, 0.2), wave(x, y, n, 1, -1, 0.4), 1.0);
                   }),
                   sampler);
    m.normal.texture = addTexture(scene, torusTexels(torusNormalTexel), sampler);
    m.normalScale = 0.8;
    m.occlusion.texture = addTexture(
        scene, torusTexels([](int x, int y) { return dvec4(dvec3(wave(x, y, n, 1, 0, 1.0)), 1.0); }), sampler);
    m.occlusionStrength = 0.7;
    m.emissiveFactor = dvec3(0.3, 0.2, 0.1);
    m.emissive.texture = addTexture(scene, torusTexels([](int x, int y) {
                                        const double w = wave(x, y, n, 2, 3, 0.0);
                                        return dvec4(dvec3(w * w * w), 1.0);
                                    }),
                                    sampler);
    scene.materials.push_back(m);
    Primitive mesh = torusMesh();
    mesh.name = "torus";
    mesh.material = 0;
    addInstance(scene, std::move(mesh), dmat4(1.0));
    return scene;
}

Scene demoScene()
{
    Scene scene = loadScene(dataFolder() / "assets" / "demo" / "demo.gltf").scene;
    scene.environment = Environment{};
    scene.environment->radiance =
        loadEnvironment((dataFolder() / "assets" / "environments" / "studio.hdr").string()).radiance;
    return scene;
}

} // namespace torrance::test
