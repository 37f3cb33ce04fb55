#include "reference/surface_point.h"

#include "reference/analytic_shape.h"
#include "reference/material_point.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace torrance {
namespace {

/// The square |x|, |y| <= 1 at z = 0, front towards +Z, with texture coordinates and tangents along +X.
Scene squareScene()
{
    Scene scene;
    Primitive p;
    p.positions = {vec3(-1, -1, 0), vec3(1, -1, 0), vec3(1, 1, 0), vec3(-1, 1, 0)};
    p.normals.assign(4, vec3(0, 0, 1));
    p.tangents.assign(4, vec4(1, 0, 0, 1));
    p.uvs[0] = {vec2(0, 1), vec2(1, 1), vec2(1, 0), vec2(0, 0)};
    p.indices = {0, 1, 2, 0, 2, 3};
    p.material = 0;
    scene.primitives.push_back(p);
    scene.instances.push_back({.primitive = 0, .object = 3, .worldFromObject = dmat4(1.0)});
    scene.materials.emplace_back();
    return scene;
}

SurfacePoint pointSeen(const RayCaster& caster, const Ray& ray)
{
    const std::optional<Hit> hit = caster.closest(ray);
    EXPECT_TRUE(hit.has_value());
    return hit ? makeSurfacePoint(caster, ray, *hit) : SurfacePoint{};
}

TEST(RayCaster, RecomputesTheHitInDouble)
{
    const Scene scene = squareScene();
    const RayCaster caster(scene, dvec3(0, 0, 3));
    const Ray ray{dvec3(0.0), glm::normalize(dvec3(0.1, 0.2, -1.0))};
    const SurfacePoint point = pointSeen(caster, ray);
    EXPECT_LT(glm::distance(point.position, dvec3(0.3, 0.6, -3.0)), 1e-14);
    EXPECT_LT(glm::distance(point.uvs[0], dvec2(0.65, 0.2)), 1e-14);
    EXPECT_EQ(point.object, 3);
    EXPECT_TRUE(point.front);
}

TEST(RayCaster, FarFromTheOriginNothingIsLost)
{
    // At 1e7 metres neighbouring floats are one metre apart.
    Scene scene = squareScene();
    const dvec3 place(1e7, -2e7, 3e7);
    scene.instances[0].worldFromObject[3] = dvec4(place, 1.0);
    const RayCaster caster(scene, place + dvec3(0, 0, 3));
    const SurfacePoint point = pointSeen(caster, {dvec3(0.0), glm::normalize(dvec3(0.1, 0.2, -1.0))});
    EXPECT_LT(glm::distance(point.position, dvec3(0.3, 0.6, -3.0)), 1e-7);
}

TEST(RayCaster, BackFacesOfSingleSidedMaterialsAreNotThere)
{
    Scene scene = squareScene();
    const Ray fromBehind{dvec3(0.1, 0.2, -1.0), dvec3(0, 0, 1)};
    EXPECT_FALSE(RayCaster(scene, dvec3(0)).closest(fromBehind));
    scene.instances[0].worldFromObject[0][0] = -1.0; // mirrored: the winding turns round with it
    EXPECT_FALSE(RayCaster(scene, dvec3(0)).closest(fromBehind));
    EXPECT_TRUE(RayCaster(scene, dvec3(0)).closest({dvec3(0.1, 0.2, 1.0), dvec3(0, 0, -1)}));
    scene.materials[0].doubleSided = true;
    const RayCaster both(scene, dvec3(0));
    const SurfacePoint point = pointSeen(both, fromBehind);
    EXPECT_FALSE(point.front);
    EXPECT_EQ(point.geometricNormal, dvec3(0, 0, -1));
    EXPECT_EQ(makeMaterialPoint(scene, point).normal, dvec3(0, 0, -1));
}

TEST(RayCaster, LooksThroughWhatIsNotAccepted)
{
    Scene scene = squareScene();
    scene.instances.push_back(scene.instances[0]);
    scene.instances[1].worldFromObject[3] = dvec4(0, 0, -2, 1);
    const RayCaster caster(scene, dvec3(0, 0, 1));
    const Ray ray{dvec3(0.25, 0.5, 0.0), dvec3(0, 0, -1)};
    const auto second = caster.closest(ray, 0.0, [](const Hit& hit) { return hit.instance == 1; });
    ASSERT_TRUE(second);
    EXPECT_NEAR(second->distance, 3.0, 1e-14);
    const auto beyond = caster.closest(ray, 1.0);
    ASSERT_TRUE(beyond);
    EXPECT_EQ(beyond->instance, 1);
}

TEST(SurfacePoint, NormalsOfScaledAndMirroredNodesStayPerpendicular)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int trial = 0; trial < 50; ++trial) {
        Scene scene = squareScene();
        scene.materials[0].doubleSided = true;
        dmat4& m = scene.instances[0].worldFromObject;
        for (int c = 0; c < 3; ++c)
            m[c] = dvec4(unit(random), unit(random), unit(random), 0.0);
        const dvec3 target = dvec3(m * dvec4(0.3, -0.2, 0.0, 1.0));
        const RayCaster caster(scene, dvec3(0));
        const dvec3 start = target + dvec3(unit(random), unit(random), 2.0);
        const SurfacePoint point = pointSeen(caster, {start, glm::normalize(target - start)});
        EXPECT_NEAR(glm::dot(point.normal, dvec3(m[0])), 0.0, 1e-12);
        EXPECT_NEAR(glm::dot(point.normal, dvec3(m[1])), 0.0, 1e-12);
        EXPECT_GT(glm::dot(point.normal, dvec3(m[2])), 0.0) << "the front stays the front of the object";
        ASSERT_TRUE(point.frame);
        EXPECT_GT(glm::dot(point.frame->bitangent, dvec3(m[1])), 0.0) << "the bitangent follows the texture's v";
    }
}

TEST(AnalyticShape, FarSmallSphereKeepsItsNormal)
{
    // A sphere of one millimetre a kilometre away: b^2 - c would leave three digits of its half chord.
    AnalyticShape sphere;
    sphere.worldFromObject = dmat4(1e-3);
    sphere.worldFromObject[3] = dvec4(0, 0, -1000, 1);
    const Ray ray{dvec3(0.0), glm::normalize(dvec3(5e-4, 0.0, -1000.0))};
    const auto hit = intersectShape(sphere, dvec3(0), ray, Sides::front);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->normal.x, 0.5, 1e-6);
    EXPECT_NEAR(hit->normal.z, std::sqrt(0.75), 1e-6);
    EXPECT_NEAR(glm::length(hit->normal), 1.0, 1e-15);
}

TEST(SurfacePoint, AMeshWithoutTangentsTakesThoseOfItsNormalMap)
{
    Scene scene = squareScene();
    scene.primitives[0].tangents.clear();
    const Ray ray{dvec3(0.1, 0.2, 1.0), dvec3(0, 0, -1)};
    EXPECT_FALSE(pointSeen(RayCaster(scene, dvec3(0)), ray).frame) << "no map asks for one";
    TextureUse& map = scene.materials[0].normal;
    map.texture = 0;
    const auto frameOf = [&] { return pointSeen(RayCaster(scene, dvec3(0)), ray).frame.value_or(TangentFrame{}); };
    EXPECT_LT(glm::distance(frameOf().tangent, dvec3(1, 0, 0)), 1e-7);
    EXPECT_LT(glm::distance(frameOf().bitangent, dvec3(0, 1, 0)), 1e-7);
    map.transform = glm::dmat3x2(0.0, 1.0, -1.0, 0.0, 0.0, 0.0); // u' = -v grows along +Y, v' = u falls along -X
    EXPECT_LT(glm::distance(frameOf().tangent, dvec3(0, 1, 0)), 1e-7);
    EXPECT_LT(glm::distance(frameOf().bitangent, dvec3(-1, 0, 0)), 1e-7);
}

TEST(AnalyticShape, SidesAndMisses)
{
    const AnalyticShape sphere;
    EXPECT_FALSE(intersectShape(sphere, dvec3(0), {dvec3(0, 0, 3), dvec3(0, 0, 1)}, Sides::both)) << "behind";
    EXPECT_FALSE(intersectShape(sphere, dvec3(0), {dvec3(0, 2, 3), dvec3(0, 0, -1)}, Sides::both)) << "beside";
    EXPECT_FALSE(intersectShape(sphere, dvec3(0), {dvec3(0), dvec3(0, 0, -1)}, Sides::front)) << "from inside";
    const auto inside = intersectShape(sphere, dvec3(0), {dvec3(0, 0, 0.5), dvec3(0, 0, -1)}, Sides::both);
    ASSERT_TRUE(inside);
    EXPECT_DOUBLE_EQ(inside->distance, 1.5);
    AnalyticShape plane;
    plane.kind = AnalyticShape::Kind::plane;
    const auto met = intersectShape(plane, dvec3(0), {dvec3(0.5, -0.5, 2), dvec3(0, 0, -1)}, Sides::front);
    ASSERT_TRUE(met);
    EXPECT_DOUBLE_EQ(met->distance, 2.0);
    EXPECT_FALSE(intersectShape(plane, dvec3(0), {dvec3(1.01, 0, 2), dvec3(0, 0, -1)}, Sides::both));
    EXPECT_FALSE(intersectShape(plane, dvec3(0), {dvec3(0, 0, -2), dvec3(0, 0, 1)}, Sides::front)) << "the back";
}

TEST(MaterialPoint, MultipliesFactorsTexturesAndVertexColours)
{
    Scene scene = squareScene();
    TextureImage image;
    image.width = image.height = 1;
    for (const int v : {51, 102, 204, 255})
        image.texels.push_back(static_cast<std::byte>(v));
    scene.images.push_back(image);
    scene.textures.push_back({0, Sampler{}});
    Material& m = scene.materials[0];
    m.metallicRoughness.texture = m.occlusion.texture = m.normal.texture = 0;
    m.metallicFactor = 0.5;
    m.roughnessFactor = 0.25;
    m.occlusionStrength = 0.5;
    m.normalScale = 2.0;
    m.baseColorFactor = dvec4(0.5, 1.0, 1.0, 0.5);
    scene.primitives[0].colors.assign(4, vec4(0.5f, 0.25f, 1.0f, 0.5f));
    const RayCaster caster(scene, dvec3(0));
    const Ray ray{dvec3(0.1, 0.2, 1.0), dvec3(0, 0, -1)};
    const MaterialPoint point = makeMaterialPoint(scene, pointSeen(caster, ray));
    EXPECT_DOUBLE_EQ(point.metallic, 0.4) << "blue";
    EXPECT_DOUBLE_EQ(point.perceptualRoughness, 0.1) << "green";
    EXPECT_DOUBLE_EQ(point.occlusion, 0.6) << "1 + (0.2 - 1) / 2, red";
    EXPECT_EQ(point.baseColor, dvec3(0.25, 0.25, 1.0));
    EXPECT_EQ(point.alpha, 1.0) << "opaque ignores alpha";
    // (2 * 0.2 - 1) * 2 = -1.2, (2 * 0.4 - 1) * 2 = -0.4, 2 * 0.8 - 1 = 0.6
    EXPECT_LT(glm::distance(point.normal, glm::normalize(dvec3(-1.2, -0.4, 0.6))), 1e-14);
}

TEST(MaterialPoint, NormalsTurnedAwayAreBentTowardsTheViewer)
{
    Scene scene = squareScene();
    scene.primitives[0].normals.assign(4, vec3(0, 0.6f, -0.8f));
    const RayCaster caster(scene, dvec3(0));
    const dvec3 normal = makeMaterialPoint(scene, pointSeen(caster, {dvec3(0.1, 0.2, 1.0), dvec3(0, 0, -1)})).normal;
    EXPECT_NEAR(normal.z, kMinNoV / 0.6, 1e-9) << "(0, 0.6, kMinNoV) made unit";
    EXPECT_NEAR(normal.y, 1.0, 1e-6);
}

TEST(MaterialPoint, AlphaModes)
{
    Scene scene = squareScene();
    scene.materials[0].baseColorFactor.a = 0.5;
    const RayCaster caster(scene, dvec3(0));
    const SurfacePoint point = pointSeen(caster, {dvec3(0.1, 0.2, 1.0), dvec3(0, 0, -1)});
    scene.materials[0].alphaMode = AlphaMode::blend;
    EXPECT_EQ(coverageAt(scene, point), 0.5);
    scene.materials[0].alphaMode = AlphaMode::mask;
    EXPECT_EQ(coverageAt(scene, point), 1.0) << "alpha equal to the cutoff is kept";
    scene.materials[0].alphaCutoff = 0.6;
    EXPECT_EQ(coverageAt(scene, point), 0.0);
}

} // namespace
} // namespace torrance
