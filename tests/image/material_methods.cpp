// Materials that compute light each in its own way are drawn as where all do it in that way, to the bit; and a
// tolerance finds such a picture.
#include "drawing.h"
#include "gpu/test_device.h"
#include "plan/path_plan.h"
#include "scene/camera_fit.h"
#include "scenes.h"
#include "study/tolerance_search.h"
#include "tests/panorama_of.h"
#include "tests/shipped_table.h"
#include "two_paths.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

constexpr int kSize = 64;

const brdf::Method* specular(const char* id)
{
    return brdf::findMethod(brdf::Slot::environmentSpecular, id);
}

LightMethods directions(const Settings& asked, const char* id, int samples)
{
    Settings own = asked;
    own.methods.environmentSpecular = specular(id);
    own.environmentSamples = samples;
    return lightMethodsOf(own);
}

/// Two tori, textured and not, and two balls, right and left of the middle, in the light of a lamp with a radius and of
/// a panorama with a small sun.
Scene pairs()
{
    Scene scene = texturedTorus();
    scene.instances[0].worldFromObject = translation({-1.6, 0.0, 0.0});
    Primitive other = scene.primitives[0];
    other.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back({.name = "plain", .roughnessFactor = 0.3});
    addInstance(scene, other, translation({1.6, 0.0, 0.0}));
    for (const double side : {-1.6, 1.6})
        scene.shapes.push_back({.kind = AnalyticShape::Kind::sphere,
                                .material = side < 0.0 ? 0 : other.material,
                                .worldFromObject = translation({side, 0.0, 0.0}) * dmat4(dmat3(0.4)),
                                .name = "ball"});
    Light lamp = testLight(Light::Kind::point);
    lamp.radius = 0.3;
    scene.lights = {lamp};
    const dvec3 sun = glm::normalize(dvec3(0.3, 0.8, 0.5));
    scene.environment =
        panoramaOf([&](const dvec3& d) { return glow(d) + dvec3(300.0 * (glm::dot(d, sun) > 0.995)); }, 64);
    return scene;
}

Camera fromAbove(const Scene& scene)
{
    return fitCamera(scene, {0.0, 0.9}, 1.0, 0.7, 0.05);
}

/// The middle of the picture is where no pair reaches to.
void expectHalves(const Picture& mixed, const Picture& left, const Picture& right, const std::string& name)
{
    int apart = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const Picture& own = x < kSize / 2 ? left : right;
            const Picture& other = x < kSize / 2 ? right : left;
            ASSERT_EQ(pixelOf(mixed, x, y), pixelOf(own, x, y)) << name << " at " << x << ", " << y;
            apart += pixelOf(mixed, x, y) != pixelOf(other, x, y);
        }
    EXPECT_GT(apart, kSize * kSize / 10) << name << ": both ways draw the same";
}

TEST(MaterialMethods, AreDrawnAsInPicturesOfTheirOwn)
{
    const Scene scene = pairs();
    Settings asked = settingsOf("standard", kSize);
    Settings other = asked;
    other.methods.environmentDiffuse = brdf::findMethod(brdf::Slot::environmentDiffuse, "sh4");
    other.methods.dfg = brdf::findMethod(brdf::Slot::dfg, "karis_mobile");
    other.methods.areaLight = brdf::findMethod(brdf::Slot::areaLight, "sampled");
    other.lightSamples = 8;
    const LightMethods few = directions(asked, "vndf_lamps", 8), many = directions(asked, "vndf_lamps", 64),
                       plain = directions(asked, "vndf_bounded", 8), own = lightMethodsOf(other);
    for (const RenderPath path : kRenderPaths) {
        asked.path = path;
        for (const auto& [left, right] : {std::pair(few, many), {plain, few}, {lightMethodsOf(asked), own}}) {
            Settings mixed = withLightMethods(asked, left);
            mixed.ofMaterials = {{1, right}};
            const Camera camera = fromAbove(scene);
            expectHalves(draw(scene, camera, mixed), draw(scene, camera, withLightMethods(asked, left)),
                         draw(scene, camera, withLightMethods(asked, right)),
                         nameOf(path) + (": " + materialMethodsText(1, right)));
        }
    }
}

/// A ball of chalk beside one of polished metal and a sign that is not lit.
Scene chalkAndMetal()
{
    Scene scene;
    scene.materials = {{.name = "chalk", .metallicFactor = 0.0, .ior = 1.1},
                       {.name = "metal", .roughnessFactor = 0.35},
                       {.name = "sign", .baseColorFactor = dvec4(0.02, 0.02, 0.02, 1.0), .unlit = true}};
    for (const int i : {0, 1, 2})
        scene.shapes.push_back({.kind = AnalyticShape::Kind::sphere,
                                .material = i,
                                .worldFromObject = translation({2.2 * i, 0.0, 0.0}),
                                .name = "ball"});
    const dvec3 window = glm::normalize(dvec3(0.5, 0.6, 0.6));
    scene.environment = panoramaOf(
        [&](const dvec3& d) { return dvec3(0.5 + 0.3 * d.y) + dvec3(40.0 * (glm::dot(d, window) > 0.99)); }, 64);
    return scene;
}

ToleranceResult found(const Scene& scene, const Camera& camera, double tolerance, bool byMaterial)
{
    const MethodTable table = shippedTable();
    Picture drawn;
    return drawWithin({.scene = scene,
                       .camera = camera,
                       .asked = settingsOf("standard", kSize),
                       .table = table,
                       .tolerance = {.mean = tolerance, .percentile99 = {}},
                       .byMaterial = byMaterial},
                      [&](const Settings& settings, std::span<const PixelBox>) -> const Image& {
                          drawn = draw(scene, camera, settings);
                          return drawn.color;
                      });
}

// Chalk, which mirrors next to nothing, is content with what was tried first, where metal needs more.
TEST(MaterialMethods, ATolerancesGiveEachWhatItNeeds)
{
    const Scene scene = chalkAndMetal();
    const Camera camera = fitCamera(scene, {0.2, 1.2}, 1.0, 0.7, 0.05);
    const ToleranceResult one = found(scene, camera, 0.01, false), each = found(scene, camera, 0.01, true);
    ASSERT_TRUE(one.holds && each.holds);
    EXPECT_TRUE(one.settings.ofMaterials.empty());
    std::string tried;
    for (const std::string& line : toleranceLines(each))
        tried += line + "\n";
    ASSERT_EQ(each.settings.ofMaterials.size(), 1u) << tried;
    const auto& [material, methods] = *each.settings.ofMaterials.begin();
    EXPECT_EQ(material, 0);
    EXPECT_NE(methods, lightMethodsOf(each.settings));
    EXPECT_EQ(lightMethodsOf(each.settings), lightMethodsOf(one.settings));
    EXPECT_EQ(each.trials.size(), one.trials.size() + 1);
    EXPECT_EQ(each.trials.back().cheaper, std::vector{0});
    EXPECT_GE(each.certificate.shading.mean.value, one.certificate.shading.mean.value);
    EXPECT_LE(each.certificate.shading.mean.high, 0.01);
}

} // namespace
} // namespace torrance::test
