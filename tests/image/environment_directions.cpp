// Which way round: lat-long environments and the orbit camera.
#include "drawing.h"
#include "scene/camera_fit.h"
#include "scenes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace torrance::test {
namespace {

const dvec3 kRed(1, 0, 0), kGreen(0, 1, 0), kBlue(0, 0, 1), kYellow(1, 1, 0), kWhite(1, 1, 1), kCyan(0, 1, 1);

/// As three.js, Filament, F3D and Blender place directions in a panorama: +X in the middle of the columns, +Z three
/// quarters along, -X at the ends, -Z at a quarter; +Y in the top row, -Y in the bottom one.
dvec3 panoramaColor(double u, double v)
{
    if (v < 0.25)
        return kWhite;
    if (v > 0.75)
        return kCyan;
    if (std::abs(u - 0.5) < 0.125)
        return kRed;
    if (std::abs(u - 0.75) < 0.125)
        return kGreen;
    return std::abs(u - 0.25) < 0.125 ? kYellow : kBlue;
}

Scene panoramaScene()
{
    Scene scene;
    Environment environment;
    environment.name = "directions";
    environment.radiance = Image(64, 32, 3);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x)
            for (int c = 0; c < 3; ++c)
                environment.radiance.at(x, y)[c] = static_cast<float>(panoramaColor((x + 0.5) / 64, (y + 0.5) / 32)[c]);
    scene.environment = environment;
    return scene;
}

Picture lookFrom(const Scene& scene, const dvec3& direction, double fov)
{
    Settings settings = settingsOf("gltf", 33);
    settings.background = BackgroundKind::environment;
    return draw(scene, lookAtCamera(dvec3(0), direction, dvec3(0, 1, 0), fov), settings);
}

void expectColor(const dvec4& drawn, const dvec3& color, const std::string& what)
{
    EXPECT_LT(glm::distance(dvec3(drawn), color), 1e-5) << what << ": " << drawn.r << ' ' << drawn.g << ' ' << drawn.b;
}

TEST(EnvironmentDirections, AxesLieWhereOtherViewersPutThem)
{
    const Scene scene = panoramaScene();
    const std::pair<dvec3, dvec3> cases[] = {{dvec3(1, 0, 0), kRed},   {dvec3(0, 0, 1), kGreen},
                                             {dvec3(-1, 0, 0), kBlue}, {dvec3(0, 0, -1), kYellow},
                                             {dvec3(0, 1, 0), kWhite}, {dvec3(0, -1, 0), kCyan}};
    for (const auto& [direction, color] : cases)
        expectColor(pixelOf(lookFrom(scene, direction, 0.5), 16, 16), color, "straight ahead");
}

TEST(EnvironmentDirections, IsNotMirrored)
{
    // Towards -Z with +Y up, +X is on the right.
    const Picture picture =
        lookFrom(panoramaScene(), dvec3(0, 0, -1), 2.3); // half the picture is tan(1.15) = 66 degrees
    expectColor(pixelOf(picture, 16, 16), kYellow, "centre");
    expectColor(pixelOf(picture, 32, 16), kRed, "right");
    expectColor(pixelOf(picture, 0, 16), kBlue, "left");
    expectColor(pixelOf(picture, 16, 0), kWhite, "top");
    expectColor(pixelOf(picture, 16, 32), kCyan, "bottom");
}

TEST(EnvironmentDirections, TurnsCounterClockwiseSeenFromAbove)
{
    Scene scene = panoramaScene();
    scene.environment->rotation = kPi / 2; // about +Y this brings +Z to +X
    expectColor(pixelOf(lookFrom(scene, dvec3(1, 0, 0), 0.5), 16, 16), kGreen, "+X");
    expectColor(pixelOf(lookFrom(scene, dvec3(0, 0, -1), 0.5), 16, 16), kRed, "-Z");
}

TEST(EnvironmentDirections, IntensityScalesTheBackground)
{
    Scene scene = panoramaScene();
    scene.environment->intensity = 3.0;
    expectColor(pixelOf(lookFrom(scene, dvec3(1, 0, 0), 0.5), 16, 16), 3.0 * kRed, "+X");
}

TEST(EnvironmentDirections, ReflectionsAndIrradianceLieTheSameWay)
{
    // A mirror facing the camera shows what is behind the camera; a matte white ball is lit by the half it faces.
    Scene scene = panoramaScene();
    scene.environment->rotation = kPi / 2;
    scene.materials.push_back(plainMaterial(dvec3(1.0), 1.0, 0.0));
    scene.shapes.push_back(
        {.kind = AnalyticShape::Kind::sphere, .material = 0, .worldFromObject = dmat4(1.0), .name = "ball"});
    const Settings settings = settingsOf("gltf", 33);
    const Picture mirror =
        draw(scene, orbitCamera({kPi / 2, kPi / 2}, 4.0, dvec3(0), 0.6), settings); // from +X: what lay at +Z
    EXPECT_LT(glm::distance(dvec3(pixelOf(mirror, 16, 16)), kGreen), 0.02);
    scene.materials[0] = plainMaterial(dvec3(1.0), 0.0, 1.0);
    const dvec3 matte(pixelOf(draw(scene, orbitCamera({kPi / 2, kPi / 2}, 4.0, dvec3(0), 0.6), settings), 16, 16));
    EXPECT_GT(matte.g, matte.r) << "green light comes from +X";
    EXPECT_GT(matte.g, matte.b);
}

TEST(OrbitPicture, FrontRightAndTopOfAnAsset)
{
    // Three unlit squares a metre out along +Z, +X and +Y, each facing outwards.
    Scene scene;
    const dvec3 colors[] = {kRed, kGreen, kBlue};
    for (const dvec3& color : colors) {
        scene.materials.push_back(plainMaterial(color, 0.0, 1.0));
        scene.materials.back().unlit = true;
    }
    const dmat4 turns[] = {
        dmat4(1.0), dmat4(dvec4(0, 0, -1, 0), dvec4(0, 1, 0, 0), dvec4(1, 0, 0, 0), dvec4(0, 0, 0, 1)), // +Z to +X
        dmat4(dvec4(1, 0, 0, 0), dvec4(0, 0, -1, 0), dvec4(0, 1, 0, 0), dvec4(0, 0, 0, 1)),             // +Z to +Y
    };
    for (int i = 0; i < 3; ++i)
        addInstance(scene, square(i), turns[i] * translation(dvec3(0, 0, 1)));
    const OrbitAngles angles[] = {{0.0, kPi / 2}, {kPi / 2, kPi / 2}, {0.0, 0.0}};
    for (int i = 0; i < 3; ++i) {
        const Camera camera = fitNearPlane(orbitCamera(angles[i], 5.0, dvec3(0), 0.5), scene);
        expectColor(pixelOf(draw(scene, camera, settingsOf("gltf", 17)), 8, 8), colors[i], "side " + std::to_string(i));
    }
}

} // namespace
} // namespace torrance::test
