// Alpha, colours, wrap modes, points and lines, and inputs at their limits.
#include "drawing.h"
#include "mesh_truth.h"
#include "scene/camera_fit.h"
#include "scenes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

constexpr int kSize = 32;
constexpr double kFloat = 1e-6; // a few roundings of numbers of order one

/// Sees exactly the square |x|, |y| <= 1 of z = 0.
Camera facingCamera()
{
    Camera camera = orbitCamera({}, 3.0, dvec3(0), 2.0 * std::atan(1.0 / 3.0));
    camera.nearPlane = 0.1;
    return camera;
}

Material unlitMaterial(const dvec4& color)
{
    Material material = plainMaterial(dvec3(color), 0.0, 1.0);
    material.baseColorFactor = color;
    material.unlit = true;
    return material;
}

Scene squareScene(const Material& material)
{
    Scene scene;
    scene.materials.push_back(material);
    addInstance(scene, square(0), dmat4(1.0));
    return scene;
}

Picture drawFacing(const Scene& scene, const char* preset = "gltf")
{
    return draw(scene, facingCamera(), settingsOf(preset, kSize));
}

void expectFinite(const Picture& picture, const std::string& what)
{
    for (const float v : picture.color.texels)
        ASSERT_TRUE(std::isfinite(v)) << what;
}

TEST(Surfaces, UnlitShowsItsBaseColourAndNothingElse)
{
    Material material = unlitMaterial(dvec4(0.1, 0.2, 0.7, 1.0));
    material.emissiveFactor = dvec3(1.0);
    Scene scene = squareScene(material);
    scene.lights.push_back(testLight(Light::Kind::directional));
    scene.environment = uniformEnvironment(dvec3(1.0));
    EXPECT_EQ(pixelOf(drawFacing(scene), 5, 20), dvec4(0.1f, 0.2f, 0.7f, 1.0));
}

TEST(Surfaces, EmissionIsNotBoundedByOne)
{
    Material material = plainMaterial(dvec3(0.0), 1.0, 0.5);
    material.emissiveFactor = dvec3(0.5, 8.0, 1000.0);
    EXPECT_EQ(pixelOf(drawFacing(squareScene(material)), 5, 20), dvec4(0.5, 8.0, 1000.0, 1.0));
}

TEST(Surfaces, MaskKeepsOrDropsWholePixels)
{
    Material material = unlitMaterial(dvec4(1.0));
    material.alphaMode = AlphaMode::mask;
    material.alphaCutoff = 0.4;
    Scene scene = squareScene(material);
    scene.materials[0].baseColor.texture = addTexture(
        scene,
        makeTexels(2, 1, TexelFormat::rgba8, [](int x, int) { return dvec4(1.0, 1.0, 1.0, x == 0 ? 0.2 : 0.6); }),
        levelZero(Filter::nearest, Wrap::clampToEdge));
    const Picture picture = drawFacing(scene);
    EXPECT_EQ(pixelOf(picture, 8, 16), dvec4(0.0)) << "below the cutoff there is nothing";
    EXPECT_EQ(pixelOf(picture, 24, 16), dvec4(1.0)) << "above it the surface is whole";
}

TEST(Surfaces, BlendsBackToFrontWhateverTheOrderInTheFile)
{
    // Premultiplied "over" (Porter & Duff 1984): near + (1 - alpha) far.
    for (const bool nearFirst : {true, false}) {
        Scene scene;
        scene.materials = {unlitMaterial(dvec4(1, 0, 0, 0.5)), unlitMaterial(dvec4(0, 1, 0, 0.25))};
        for (Material& m : scene.materials)
            m.alphaMode = AlphaMode::blend;
        addInstance(scene, square(nearFirst ? 0 : 1), translation(dvec3(0, 0, nearFirst ? 0.1 : -0.5)));
        addInstance(scene, square(nearFirst ? 1 : 0), translation(dvec3(0, 0, nearFirst ? -0.5 : 0.1)));
        const dvec4 drawn = pixelOf(drawFacing(scene), 16, 16);
        EXPECT_LT(glm::distance(drawn, dvec4(0.5, 0.125, 0.0, 0.625)), kFloat) << "near first: " << nearFirst;
    }
}

TEST(Surfaces, BlendedSurfacesHideBehindOpaqueOnes)
{
    Scene scene = squareScene(unlitMaterial(dvec4(0, 0, 1, 1)));
    scene.materials.push_back(unlitMaterial(dvec4(1, 0, 0, 0.5)));
    scene.materials.back().alphaMode = AlphaMode::blend;
    addInstance(scene, square(1), translation(dvec3(0, 0, -0.5)));
    EXPECT_EQ(pixelOf(drawFacing(scene), 16, 16), dvec4(0, 0, 1, 1));
    scene.instances.back().worldFromObject = translation(dvec3(0, 0, 0.5));
    EXPECT_LT(glm::distance(pixelOf(drawFacing(scene), 16, 16), dvec4(0.5, 0, 0.5, 1)), kFloat);
}

TEST(Surfaces, OpaqueIgnoresAlpha)
{
    EXPECT_EQ(pixelOf(drawFacing(squareScene(unlitMaterial(dvec4(0.5, 0.25, 1.0, 0.3)))), 16, 16),
              dvec4(0.5, 0.25, 1.0, 1.0));
}

TEST(Surfaces, BackgroundColourFillsWhatIsNotCovered)
{
    Settings settings = settingsOf("gltf", kSize);
    settings.background = BackgroundKind::color;
    settings.backgroundColor = dvec3(0.25, 0.5, 2.0);
    Scene scene = squareScene(unlitMaterial(dvec4(1.0)));
    scene.instances[0].worldFromObject = dmat4(dmat3(0.5));
    const Picture picture = draw(scene, facingCamera(), settings);
    EXPECT_EQ(pixelOf(picture, 0, 0), dvec4(0.25, 0.5, 2.0, 1.0));
    EXPECT_EQ(pixelOf(picture, 16, 16), dvec4(1.0));
}

TEST(Surfaces, WrapModesOfBothAxes)
{
    // Three texels, each its own colour, seen through coordinates from -1 to 2.
    const Wrap wraps[] = {Wrap::repeat, Wrap::mirroredRepeat, Wrap::clampToEdge};
    for (const Wrap s : wraps)
        for (const Wrap t : wraps)
            for (const Filter filter : {Filter::nearest, Filter::linear}) {
                Scene scene = squareScene(unlitMaterial(dvec4(1.0)));
                Sampler sampler = levelZero(filter);
                sampler.wrapS = s;
                sampler.wrapT = t;
                const auto texel = [](int x, int y) {
                    return dvec4(0.2 + 0.4 * x, 0.1 + 0.2 * y, 0.9 - 0.3 * x * y, 1.0);
                };
                scene.materials[0].baseColor.texture =
                    addTexture(scene, makeTexels(3, 4, TexelFormat::rgba8, texel), sampler);
                scene.primitives[0].uvs[0] = {vec2(-1, 2), vec2(2, 2), vec2(2, -1), vec2(-1, -1)};
                // 1/512 pixel of lavapipe's vertex grid moves a bilinear value by 1e-3 of the texels' difference
                expectDrawnAsCast(scene, facingCamera(), settingsOf("gltf", kSize), 1e-3,
                                  "wrap-" + std::to_string(static_cast<int>(s)) + std::to_string(static_cast<int>(t)));
            }
}

TEST(Surfaces, TextureTransformAndSecondSet)
{
    Scene scene = squareScene(unlitMaterial(dvec4(1.0)));
    const auto texel = [](int x, int y) { return dvec4(x / 7.0, y / 7.0, 0.5, 1.0); };
    Material& material = scene.materials[0];
    material.baseColor.texture = addTexture(scene, makeTexels(8, 8, TexelFormat::rgba16, texel),
                                            levelZero(Filter::linear, Wrap::mirroredRepeat));
    material.baseColor.uvSet = 1;
    // KHR_texture_transform: translation * rotation * scale
    const double angle = 0.6;
    material.baseColor.transform = glm::dmat3x2(1.5 * std::cos(angle), -1.5 * std::sin(angle), 0.8 * std::sin(angle),
                                                0.8 * std::cos(angle), 0.1, 0.3);
    scene.primitives[0].uvs[1] = {vec2(0, 2), vec2(2, 2), vec2(2, 0), vec2(0, 0)};
    expectDrawnAsCast(scene, facingCamera(), settingsOf("gltf", 48), 1e-3, "texture-transform");
}

TEST(Surfaces, VertexColoursMultiplyTheBaseColour)
{
    Scene scene = squareScene(unlitMaterial(dvec4(0.5, 1.0, 0.25, 1.0)));
    scene.primitives[0].colors = {vec4(1, 0, 0, 1), vec4(0, 1, 0, 1), vec4(0, 0, 1, 1), vec4(1, 1, 1, 1)};
    expectDrawnAsCast(scene, facingCamera(), settingsOf("gltf", 48), 1e-3, "vertex-colours");
}

TEST(Surfaces, DoubleSidedBacksAreLitFromBehind)
{
    Scene scene = squareScene(plainMaterial(dvec3(0.8), 0.0, 0.5));
    scene.instances[0].worldFromObject[0][0] = -1.0;
    scene.instances[0].worldFromObject[2][2] = -1.0; // half a turn about Y: the back is seen
    scene.lights.push_back(testLight(Light::Kind::point));
    EXPECT_EQ(pixelOf(drawFacing(scene), 16, 16), dvec4(0.0)) << "single-sided";
    scene.materials[0].doubleSided = true;
    expectDrawnAsCast(scene, facingCamera(), settingsOf("gltf", kSize), 1e-3, "double-sided");
    EXPECT_GT(pixelOf(drawFacing(scene), 16, 16).r, 0.01);
}

int coveredPixels(const Picture& picture)
{
    int count = 0;
    for (int y = 0; y < picture.color.height; ++y)
        for (int x = 0; x < picture.color.width; ++x)
            count += pixelOf(picture, x, y).a > 0.0 ? 1 : 0;
    return count;
}

TEST(Surfaces, PointsAndLinesAreDrawn)
{
    Scene scene = squareScene(plainMaterial(dvec3(0.25, 0.5, 1.0), 0.0, 1.0));
    Primitive& p = scene.primitives[0];
    p.normals.clear();
    p.tangents.clear();
    p.topology = Topology::lines;
    p.positions = {vec3(-0.9f, 0.01f, 0), vec3(0.9f, 0.01f, 0)};
    p.uvs[0].clear();
    p.indices = {0, 1};
    const Picture lines = drawFacing(scene);
    EXPECT_NEAR(coveredPixels(lines), 0.9 * kSize, 2.0) << "one pixel thick, 90 % of the width";
    EXPECT_EQ(pixelOf(lines, 16, 15), dvec4(0.25, 0.5, 1.0, 1.0)) << "without normals: base colour (glTF 2.0, 3.7.2.1)";
    p.topology = Topology::points;
    p.positions = {vec3(-0.51f, 0.01f, 0), vec3(0.51f, 0.01f, 0), vec3(0.01f, 0.51f, 0)};
    p.indices = {0, 1, 2};
    EXPECT_EQ(coveredPixels(drawFacing(scene)), 3);
}

TEST(Surfaces, LimitsStayFinite)
{
    for (const double roughness : {0.0, 1e-3, 1.0})
        for (const char* preset : {"gltf", "standard"}) {
            Scene scene = shapeScene(AnalyticShape::Kind::sphere, plainMaterial(dvec3(1.0), 1.0, roughness));
            scene.lights.push_back(testLight(Light::Kind::point));
            scene.lights.back().intensity = 1e5;
            scene.environment = uniformEnvironment(dvec3(1.0));
            const Camera camera = fitCamera(scene, {0.0, 1.5}, 1.0, 0.7, 0.05);
            expectFinite(draw(scene, camera, settingsOf(preset, kSize)), "roughness " + std::to_string(roughness));
        }
    for (const double scale : {1e-30, 1e-12, 1e-3, 1e6, 1e15, 1e25, 0.0}) {
        Scene scene = texturedTorus();
        scene.instances[0].worldFromObject = dmat4(dmat3(scale));
        scene.lights.push_back(testLight(Light::Kind::directional));
        const Camera camera = fitCamera(scene, {0.4, 1.0}, 1.0, 0.7, 0.05);
        const Picture picture = draw(scene, camera, settingsOf("gltf", kSize));
        expectFinite(picture, "scale 1e" + std::to_string(std::log10(scale)));
        if (scale >= 1e-12 && scale <= 1e6) {
            EXPECT_GT(coveredPixels(picture), kSize * kSize / 4) << "scale " << scale;
        }
    }
}

TEST(Surfaces, ALightOnTheSurfaceStaysFinite)
{
    Scene scene = squareScene(plainMaterial(dvec3(1.0), 0.5, 0.0));
    scene.lights.push_back(testLight(Light::Kind::point));
    scene.lights.back().position = dvec3(1.0 / kSize, -1.0 / kSize, 0.0); // in the centre of a pixel
    expectFinite(drawFacing(scene), "a light on the surface");
}

} // namespace
} // namespace torrance::test
