#include "two_paths.h"

#include "reference/pixel_condition.h"
#include "scene/camera_fit.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

/// A square of points or lines: lit where it has normals, drawn in its own colour where not.
void addThin(Scene& scene, Topology topology, bool normals, double x)
{
    Primitive p = square(0);
    p.topology = topology;
    p.tangents.clear();
    if (!normals)
        p.normals.clear();
    p.indices = {0, 1, 1, 2, 2, 3, 3, 0};
    addInstance(scene, std::move(p), translation(dvec3(x, 2.3, 0.0)));
}

} // namespace

void expectForwardPicture(const Scene& scene, const Camera& camera, Settings settings, const std::string& name,
                          double relative, const Allowance& allowance)
{
    const Picture drawn = draw(scene, camera, settings);
    settings.path = RenderPath::forward;
    const Picture forward = draw(scene, camera, settings);
    WorstExcess worst;
    int lit = 0;
    for (int y = 0; y < settings.height; ++y)
        for (int x = 0; x < settings.width; ++x) {
            const dvec4 f = pixelOf(forward, x, y), d = pixelOf(drawn, x, y);
            EXPECT_EQ(d.a, f.a) << name << " at " << x << ", " << y;
            lit += f.r + f.g + f.b > 0.0 ? 1 : 0;
            constexpr double kLeast = 1e-30; // black is allowed to be black
            const dvec3 more = allowance ? allowance(x, y) : dvec3(0.0);
            worst.note(x, y, dvec3(d), dvec3(f), relative * glm::abs(dvec3(f)) + more + kLeast);
        }
    EXPECT_GT(lit, settings.width * settings.height / 10) << name << ": hardly anything is lit";
    EXPECT_LE(worst.excess, 1.0) << name << ": " << worst.text();
}

Scene mixedScene()
{
    Scene scene;
    Material unlit = plainMaterial(dvec3(0.1, 0.2, 0.7), 0.0, 1.0);
    unlit.unlit = true;
    Material masked = plainMaterial(dvec3(0.9), 1.0, 0.9); // compensated
    masked.alphaMode = AlphaMode::mask;
    masked.alphaCutoff = 0.5;
    masked.doubleSided = true;
    masked.baseColor.texture = addTexture(
        scene, makeTexels(2, 2, TexelFormat::rgba8, [](int x, int y) { return dvec4(0.9, 0.8, 0.7, x == y); }),
        levelZero(Filter::nearest));
    Material blended = plainMaterial(dvec3(0.2, 0.9, 0.3), 0.0, 0.4);
    blended.alphaMode = AlphaMode::blend;
    blended.baseColorFactor.a = 0.4;
    scene.materials = {plainMaterial(dvec3(0.8, 0.3, 0.2), 0.0, 0.5), unlit, masked, blended};
    for (int i = 0; i < 3; ++i)
        addInstance(scene, square(i), translation(dvec3(2.2 * i, 0.0, 0.0)));
    addInstance(scene, square(3), translation(dvec3(2.2, -0.6, 0.5)));
    scene.lights = {testLight(Light::Kind::directional)};
    scene.environment = uniformEnvironment(dvec3(0.3));
    return scene;
}

Scene sceneOfAllSurfaces()
{
    Scene scene = mixedScene();
    addThin(scene, Topology::lines, true, 0.0);
    addThin(scene, Topology::lines, false, 2.2);
    addThin(scene, Topology::points, false, 4.4);
    return scene;
}

Camera orthographicCamera()
{
    Camera camera = orbitCamera({0.1, 1.4}, 8.0, dvec3(2.2, 0.8, 0.0), 0.7);
    camera.kind = Camera::Kind::orthographic;
    camera.ymag = 4.0;
    camera.nearPlane = 0.1;
    camera.farPlane = 20.0;
    return camera;
}

} // namespace torrance::test
