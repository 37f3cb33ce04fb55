// Slot specular_antialiasing: what it must leave alone, what it computes, and what it is for.
#include "brdf/specular_antialiasing.h"
#include "drawing.h"
#include "scene/camera_fit.h"
#include "scene/shape_mesh.h"
#include "scenes.h"
#include "study/analytic_scenes.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace torrance::test {
namespace {

Settings settingsWith(const char* method, int size)
{
    Settings settings = settingsOf("gltf", size);
    settings.methods.specularAntialiasing = brdf::findMethod(brdf::Slot::specularAntialiasing, method);
    return settings;
}

Light sun()
{
    Light light;
    light.direction = glm::normalize(dvec3(-0.2, -0.3, -1.0));
    light.intensity = 3.0;
    return light;
}

/// A square whose normal map, in mips, is `normals`.
Scene mappedSquare(const TextureImage& normals, double roughness)
{
    Scene scene;
    Material material = plainMaterial(dvec3(1.0), 1.0, roughness);
    material.normal.texture = addTexture(scene, normals,
                                         {.wrapS = Wrap::repeat,
                                          .wrapT = Wrap::repeat,
                                          .magnify = Filter::linear,
                                          .minify = Filter::linear,
                                          .mip = MipFilter::linear});
    scene.materials.push_back(material);
    addInstance(scene, square(0), dmat4(1.0));
    scene.lights.push_back(sun());
    return scene;
}

dvec4 encoded(const dvec3& normal)
{
    return dvec4(glm::normalize(normal) * 0.5 + 0.5, 1.0);
}

const Layer& layerOf(const Picture& picture, const std::string& name)
{
    return *std::ranges::find(picture.layers, name, &Layer::name);
}

TEST(SpecularAntialiasing, AFlatFaceStaysAsItIsToTheBit)
{
    const TextureImage flat = makeTexels(16, 16, TexelFormat::rgba8, [](int, int) { return encoded(dvec3(0, 0, 1)); });
    Scene mapped = mappedSquare(flat, 0.0);
    mapped.materials[0].normal.texture = -1; // the vertices' normals
    Scene plane = shapeScene(AnalyticShape::Kind::plane, plainMaterial(dvec3(1.0), 1.0, 0.05));
    plane.lights.push_back(sun());
    for (const Scene& scene : {mapped, plane}) {
        const Camera camera = fitCamera(scene, {}, 1.0, 0.5, 0.02);
        const Picture none = draw(scene, camera, settingsWith("none", 32));
        for (const char* method : {"toksvig", "tokuyoshi"})
            EXPECT_EQ(draw(scene, camera, settingsWith(method, 32)).color.texels, none.color.texels) << method;
    }
    // A flat map is stored wider by toksvig, which changes the normal by the map's own rounding, and no roughness at
    // all.
    const Scene scene = mappedSquare(flat, 0.25);
    Settings settings = settingsWith("toksvig", 32);
    settings.layers = true;
    const Picture picture = draw(scene, fitCamera(scene, {}, 1.0, 0.5, 0.02), settings);
    for (std::size_t i = 0; i < picture.color.texels.size() / 4; ++i)
        if (picture.color.texels[4 * i + 3] > 0.0f) {
            EXPECT_EQ(layerOf(picture, "roughness").image.texels[i], 0.25f);
        }
}

// Normals that lean by +-0.2 in turn: below level 0 every texel is their mean, of length cos(atan 0.2).
TEST(SpecularAntialiasing, ToksvigIsItsFormulaOfTheMeanNormalsLength)
{
    constexpr int kTexels = 256, kSize = 16;
    constexpr double kLean = 0.2;
    const TextureImage leaning = makeTexels(kTexels, kTexels, TexelFormat::rgba16, [](int x, int y) {
        return encoded(dvec3((x + y) % 2 == 0 ? kLean : -kLean, 0.0, 1.0));
    });
    for (const double roughness : {0.1, 0.5, 1.0}) {
        const Scene scene = mappedSquare(leaning, roughness);
        Settings settings = settingsWith("toksvig", kSize);
        settings.layers = true;
        const Picture picture = draw(scene, orbitCamera({0.0, kPi / 2}, 4.0, dvec3(0), 0.4), settings);
        brdf::NormalFootprint footprint;
        footprint.meanLength = 1.0 / std::sqrt(1.0 + kLean * kLean);
        footprint.alpha = roughness * roughness;
        const float* middle = layerOf(picture, "roughness").image.at(kSize / 2, kSize / 2);
        EXPECT_NEAR(*middle, std::sqrt(brdf::AA_toksvig(footprint)), 1e-3) << roughness << ": lengths have 16 bits";
    }
}

TEST(SpecularAntialiasing, TokuyoshiIsItsFormulaOfTheNextPixelsNormals)
{
    constexpr int kSize = 32;
    Scene scene;
    scene.materials.push_back(plainMaterial(dvec3(1.0), 1.0, 0.2));
    scene.shapes.push_back({.kind = AnalyticShape::Kind::sphere, .material = 0, .name = "ball"});
    Settings settings = settingsWith("tokuyoshi", kSize);
    settings.layers = true;
    const Picture picture = draw(scene, orbitCamera({0.0, kPi / 2}, 6.0, dvec3(0), 0.5), settings);
    const Image& normals = layerOf(picture, "normal").image;
    const auto normal = [&](int x, int y) {
        return dvec3(normals.at(x, y)[0], normals.at(x, y)[1], normals.at(x, y)[2]);
    };
    for (int y = 10; y < 22; ++y)
        for (int x = 10; x < 22; ++x) {
            brdf::NormalFootprint footprint;
            footprint.dndx = normal(x + 1, y) - normal(x, y);
            footprint.dndy = normal(x, y + 1) - normal(x, y);
            footprint.alpha = 0.04;
            EXPECT_NEAR(*layerOf(picture, "roughness").image.at(x, y), std::sqrt(brdf::AA_tokuyoshi(footprint)), 1e-5)
                << x << ' ' << y;
        }
}

// A mesh of the same sphere has its normals' derivatives from the device, which may take them anywhere in a quad of
// pixels.
TEST(SpecularAntialiasing, TokuyoshiWidensAMeshAsTheShapeItStandsFor)
{
    constexpr int kSize = 32;
    Scene shape, mesh;
    shape.materials.push_back(plainMaterial(dvec3(1.0), 1.0, 0.2));
    shape.shapes.push_back({.kind = AnalyticShape::Kind::sphere, .material = 0, .name = "ball"});
    mesh.materials = shape.materials;
    Primitive ball = sphereMesh();
    ball.material = 0;
    addInstance(mesh, std::move(ball), dmat4(1.0));
    Settings settings = settingsWith("tokuyoshi", kSize);
    settings.layers = true;
    const Camera camera = orbitCamera({0.0, kPi / 2}, 6.0, dvec3(0), 0.5);
    const Picture exact = draw(shape, camera, settings), drawn = draw(mesh, camera, settings);
    for (int y = 10; y < 22; ++y)
        for (int x = 10; x < 22; ++x) // the turn per pixel changes by a tenth from one pixel to the next
            EXPECT_NEAR(*layerOf(drawn, "roughness").image.at(x, y) / *layerOf(exact, "roughness").image.at(x, y), 1.0,
                        0.1)
                << x << ' ' << y;
}

/// How much the pixels change while the camera moves by fractions of one: the mean variance over the mean's square.
double sparkle(const Scene& scene, const char* method, int size, double pixel)
{
    constexpr int kShifts = 8;
    std::vector<double> sum, squares;
    for (int i = 0; i < kShifts; ++i) {
        const dvec3 shift(pixel * i / kShifts, pixel * (i * 3 % kShifts) / kShifts, 0.0);
        const Picture picture = draw(scene, orbitCamera({0.0, kPi / 2}, 10.0, shift, 0.3), settingsWith(method, size));
        sum.resize(picture.color.texels.size() / 4);
        squares.resize(sum.size());
        for (std::size_t p = 0; p < sum.size(); ++p) {
            const double value = picture.color.texels[4 * p];
            sum[p] += value / kShifts;
            squares[p] += value * value / kShifts;
        }
    }
    double variance = 0.0, mean = 0.0;
    for (std::size_t p = 0; p < sum.size(); ++p) {
        variance += (squares[p] - sum[p] * sum[p]) / static_cast<double>(sum.size());
        mean += sum[p] / static_cast<double>(sum.size());
    }
    return variance / (mean * mean);
}

// The highlight of a ball of some pixels is much smaller than one: it flashes where a pixel's centre meets it.
TEST(SpecularAntialiasing, TokuyoshiCalmsASmallSphere)
{
    Scene scene;
    scene.materials.push_back(plainMaterial(dvec3(1.0), 1.0, 0.15));
    scene.shapes.push_back({.kind = AnalyticShape::Kind::sphere, .material = 0, .name = "ball"});
    scene.lights.push_back(sun());
    const double pixel = 2.0 * 10.0 * std::tan(0.15) / 24;
    EXPECT_LT(sparkle(scene, "tokuyoshi", 24, pixel), 0.5 * sparkle(scene, "none", 24, pixel));
}

// Bumps far smaller than a pixel: their mean normals still differ by more than the narrow lobe is wide.
TEST(SpecularAntialiasing, ToksvigCalmsAMinifiedNormalMap)
{
    std::mt19937 random(7);
    const TextureImage bumps = makeTexels(128, 128, TexelFormat::rgba8, [&](int, int) {
        const auto lean = [&] { return 0.6 * (static_cast<double>(random()) / 0x1p32 - 0.5); };
        return encoded(dvec3(lean(), lean(), 1.0));
    });
    const Scene scene = mappedSquare(bumps, 0.1);
    const double pixel = 2.0 * 10.0 * std::tan(0.15) / 24;
    EXPECT_LT(sparkle(scene, "toksvig", 24, pixel), 0.5 * sparkle(scene, "none", 24, pixel));
}

} // namespace
} // namespace torrance::test
