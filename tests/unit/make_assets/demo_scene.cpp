#include "make_assets/demo_scene.h"

#include "make_assets/chart_atlas.h"

#include <gtest/gtest.h>

#include <cmath>

namespace torrance::assets {
namespace {

Mesh meshOf(const DemoObject& object)
{
    Mesh mesh;
    for (const DemoPart& part : object.parts)
        appendSurface(mesh, part.surface, Chart{0, 0, 2, 2}, 2);
    return mesh;
}

/// The volume that a closed mesh holds, by the divergence theorem: positive where its triangles face outwards.
double volume(const Mesh& mesh)
{
    double sum = 0.0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const dvec3 a(mesh.positions[mesh.indices[i]]);
        const dvec3 b(mesh.positions[mesh.indices[i + 1]]);
        const dvec3 c(mesh.positions[mesh.indices[i + 2]]);
        sum += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return sum;
}

const DemoObject& objectNamed(const DemoScene& scene, const std::string& name)
{
    for (const DemoObject& object : scene.objects)
        if (object.name == name)
            return object;
    throw std::runtime_error("no object " + name);
}

TEST(DemoScene, NormalsAreUnitAndFaceAsTheTrianglesDo)
{
    for (const DemoObject& object : demoScene().objects) {
        const Mesh mesh = meshOf(object);
        for (const vec3& normal : mesh.normals)
            ASSERT_NEAR(glm::length(normal), 1.0f, 1e-5f) << object.name;
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const std::uint32_t* t = &mesh.indices[i];
            const dvec3 a(mesh.positions[t[0]]);
            const dvec3 face = glm::cross(dvec3(mesh.positions[t[1]]) - a, dvec3(mesh.positions[t[2]]) - a);
            const dvec3 normal(mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]]);
            ASSERT_GT(glm::dot(face, normal), 0.0) << object.name << ", triangle " << i / 3;
        }
    }
}

TEST(DemoScene, TangentsAreUnitAndAcrossTheNormal)
{
    for (const DemoObject& object : demoScene().objects) {
        const Mesh mesh = meshOf(object);
        for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
            ASSERT_NEAR(glm::length(vec3(mesh.tangents[i])), 1.0f, 1e-5f) << object.name;
            ASSERT_NEAR(glm::dot(vec3(mesh.tangents[i]), mesh.normals[i]), 0.0f, 1e-4f) << object.name;
        }
    }
}

// Closed forms: 4/3 pi r^3; a box less its rounded edges; Pappus: a tube's section times the length of its middle line.
// A mesh inscribed in a curved surface holds a little less.
TEST(DemoScene, VolumesAreThoseOfTheShapes)
{
    const DemoScene scene = demoScene();
    const double sphere = 4.0 / 3.0 * kPi * std::pow(0.19, 3.0);
    EXPECT_NEAR(volume(meshOf(objectNamed(scene, "copper ball"))) / sphere, 1.0, 3e-3);
    EXPECT_LT(volume(meshOf(objectNamed(scene, "copper ball"))), sphere);

    const double r = 0.018; // rounded box: Steiner's formula for a box of a x b x c grown by r
    const double a = 0.42 - 2 * r;
    const double b = 0.30 - 2 * r;
    const double c = 0.42 - 2 * r;
    const double block =
        a * b * c + 2 * r * (a * b + b * c + c * a) + kPi * r * r * (a + b + c) + 4.0 / 3.0 * kPi * r * r * r;
    EXPECT_NEAR(volume(meshOf(objectNamed(scene, "block"))) / block, 1.0, 1e-3);

    const double steel = kPi * 0.085 * 0.085 * 0.34; // less the ring that its rounded edges cut off
    EXPECT_NEAR(volume(meshOf(objectNamed(scene, "steel cylinder"))) / steel, 1.0, 6e-3);
    EXPECT_GT(volume(meshOf(objectNamed(scene, "knot"))), 0.0);
    EXPECT_GT(volume(meshOf(objectNamed(scene, "vase"))), 0.0);
}

TEST(DemoScene, ChartsLieInsideTheAtlasAndApart)
{
    const DemoScene scene = demoScene();
    std::vector<Chart> all;
    for (const std::vector<Chart>& charts : layOutCharts(scene.objects))
        all.insert(all.end(), charts.begin(), charts.end());
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_LE(all[i].x + all[i].width, kAtlasSize);
        EXPECT_LE(all[i].y + all[i].height, kAtlasSize);
        for (std::size_t j = 0; j < i; ++j) {
            const bool apart = all[i].x >= all[j].x + all[j].width || all[j].x >= all[i].x + all[i].width ||
                               all[i].y >= all[j].y + all[j].height || all[j].y >= all[i].y + all[i].height;
            EXPECT_TRUE(apart) << "charts " << i << " and " << j;
        }
    }
}

TEST(DemoScene, ChartsThatDoNotFitAreRefused)
{
    std::vector<DemoObject> objects = demoScene().objects;
    objects[0].parts[0].chartHeight = kAtlasSize;
    EXPECT_THROW(layOutCharts(objects), std::runtime_error);
}

} // namespace
} // namespace torrance::assets
