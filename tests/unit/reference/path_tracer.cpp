// Paths against closed forms, against each other, and against the integrals of one surface.
#include "reference/path_tracer.h"

#include "../math/confidence.h"
#include "brdf/brdf.h"
#include "closed_forms.h"
#include "reference/pixel_estimate.h"
#include "reference/shade.h"
#include "scene/camera_fit.h"
#include "scene/shape_mesh.h"

#include <string>

namespace torrance {
namespace {

using test::agrees;
using test::difference;
using test::lambertPreset;
using test::uniform;

// --- Scenes ---------------------------------------------------------------------------------------------------------

/// Directional albedo 1 of white surfaces, metals and dielectrics, smooth and rough, from wherever they are seen.
brdf::Preset whitePreset()
{
    brdf::Preset preset = *brdf::findPreset("standard");
    preset.diffuseWeight = brdf::findMethod(brdf::Slot::diffuseWeight, "albedo_scaling");
    return preset;
}

Material material(const dvec3& color, double metallic = 0.0, double roughness = 1.0)
{
    Material m;
    m.baseColorFactor = dvec4(color, 1.0);
    m.metallicFactor = metallic;
    m.roughnessFactor = roughness;
    return m;
}

int addMaterial(Scene& scene, const Material& m)
{
    scene.materials.push_back(m);
    return static_cast<int>(scene.materials.size()) - 1;
}

void addMesh(Scene& scene, Primitive primitive, int material, const dmat4& place = dmat4(1.0))
{
    primitive.material = material;
    scene.primitives.push_back(std::move(primitive));
    scene.instances.push_back({static_cast<int>(scene.primitives.size()) - 1, 0, place});
}

/// Corners counter-clockwise as seen from the front; no normals but the triangles' own.
void addQuad(Scene& scene, const std::array<vec3, 4>& corners, int material)
{
    Primitive p;
    p.positions.assign(corners.begin(), corners.end());
    p.uvs[0] = {vec2(0, 1), vec2(1, 1), vec2(1, 0), vec2(0, 0)};
    p.indices = {0, 1, 2, 0, 2, 3};
    addMesh(scene, p, material);
}

/// |x|, |z| <= half at height y, facing up or down.
void addFloor(Scene& scene, float y, float half, int material, bool up = true)
{
    if (up)
        addQuad(scene, {vec3(-half, y, half), vec3(half, y, half), vec3(half, y, -half), vec3(-half, y, -half)},
                material);
    else
        addQuad(scene, {vec3(-half, y, -half), vec3(half, y, -half), vec3(half, y, half), vec3(-half, y, half)},
                material);
}

/// A cube of half side `half` that faces outwards, or inwards.
void addCube(Scene& scene, double half, int material, bool inwards = false)
{
    Primitive cube = cubeMesh();
    cube.normals.clear(); // the triangles' own
    cube.tangents.clear();
    if (inwards)
        for (std::size_t i = 0; i < cube.indices.size(); i += 3)
            std::swap(cube.indices[i + 1], cube.indices[i + 2]);
    addMesh(scene, cube, material, dmat4(dmat3(half)));
}

Light lamp(const dvec3& position, double intensity, double radius = 0.0)
{
    Light light;
    light.kind = Light::Kind::point;
    light.position = position;
    light.intensity = intensity;
    light.radius = radius;
    return light;
}

ReferenceSettings settingsOf(const brdf::Preset& methods, int side, DirectionChoice choice = DirectionChoice::combined)
{
    ReferenceSettings settings;
    settings.methods = methods;
    settings.transport = true;
    settings.width = settings.height = side;
    settings.background = dvec4(0.0);
    settings.choice = choice;
    return settings;
}

const DirectionChoice kChoices[] = {DirectionChoice::combined, DirectionChoice::brdf, DirectionChoice::light};

/// One pixel, of paths in every replicate.
PixelReplicates pixelOf(const Scene& scene, const Camera& camera, const ReferenceSettings& settings, int paths,
                        std::uint64_t seed = 1)
{
    return PixelEstimator(scene, camera, settings).replicates(settings.width / 2, settings.height / 2, paths, seed);
}

/// The mean over all pixels of a picture.
Replicates meanOf(const Scene& scene, const Camera& camera, const ReferenceSettings& settings, int paths,
                  std::uint64_t seed)
{
    const PixelEstimator estimator(scene, camera, settings);
    Replicates mean;
    for (int y = 0; y < settings.height; ++y)
        for (int x = 0; x < settings.width; ++x) {
            const PixelReplicates pixel = estimator.replicates(x, y, paths, seed);
            for (std::size_t r = 0; r < kReplicates; ++r)
                mean.values[r] += pixel.colors.values[r] / double(settings.width * settings.height);
        }
    return mean;
}

/// Looks down at a place of the floor y = 0 from the side, beneath what hangs above it.
Camera overFloor(const dvec3& target, double fov = 0.01)
{
    return lookAtCamera(target + dvec3(0.0, 0.5, 3.0), target, dvec3(0, 1, 0), fov);
}

// --- Closed forms ---------------------------------------------------------------------------------------------------

TEST(Transport, WhiteSurfacesAreNotSeenInTheFurnace)
{
    // A bowl of five walls with a block in it, white metal and white dielectric: light that is reflected any number of
    // times is the environment's all the same.
    for (const double metallic : {0.0, 1.0})
        for (const double roughness : {0.3, 1.0}) {
            Scene scene;
            const int white = addMaterial(scene, material(dvec3(1.0), metallic, roughness));
            addFloor(scene, 0.0f, 1.0f, white);
            addQuad(scene, {vec3(-1, 0, -1), vec3(1, 0, -1), vec3(1, 1, -1), vec3(-1, 1, -1)}, white);
            addQuad(scene, {vec3(-1, 0, 1), vec3(-1, 0, -1), vec3(-1, 1, -1), vec3(-1, 1, 1)}, white); // faces +x
            addQuad(scene, {vec3(1, 0, -1), vec3(1, 0, 1), vec3(1, 1, 1), vec3(1, 1, -1)}, white);     // faces -x
            addCube(scene, 0.25, white);
            scene.instances.back().worldFromObject[3] = dvec4(0.2, 0.25, 0.1, 1.0);
            scene.environment = uniform(dvec3(0.5, 1.0, 2.0));
            const Camera camera = lookAtCamera(dvec3(0.5, 2.5, 3.0), dvec3(0.0, 0.3, 0.0), dvec3(0, 1, 0), 0.5);
            for (const DirectionChoice choice : {DirectionChoice::combined, DirectionChoice::brdf}) {
                ReferenceSettings settings = settingsOf(whitePreset(), 6, choice);
                settings.background = std::nullopt;
                EXPECT_TRUE(agrees(meanOf(scene, camera, settings, 256, 1), dvec3(0.5, 1.0, 2.0), 1e-5, 8))
                    << metallic << ' ' << roughness;
            }
        }
}

TEST(Transport, InAClosedRoomThatEmitsEverySurfaceShowsLeOverOneLessRho)
{
    const dvec3 emission(0.25, 0.5, 1.0), rho(0.5, 0.25, 0.8);
    for (const bool ball : {false, true}) {
        Scene scene;
        Material walls = material(rho);
        walls.emissiveFactor = emission;
        walls.doubleSided = ball;
        const int m = addMaterial(scene, walls);
        if (ball)
            scene.shapes.push_back({AnalyticShape::Kind::sphere, m, dmat4(dmat3(2.0)), "ball"});
        else
            addCube(scene, 2.0, m, true);
        const Camera camera = lookAtCamera(dvec3(0.3, -0.2, 0.4), dvec3(1.0, 0.7, -1.0), dvec3(0, 1, 0), 1.0);
        for (const DirectionChoice choice : kChoices)
            EXPECT_TRUE(agrees(pixelOf(scene, camera, settingsOf(lambertPreset(), 1, choice), 1024).colors,
                               emission / (1.0 - rho), 0.0, 6))
                << ball << ' ' << int(choice);
    }
}

/// Irradiance of a horizontal place from a polygon of radiance 1 above it: Lambert 1760, by edges.
double polygonIrradiance(const dvec3& place, const std::array<vec3, 4>& corners)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const dvec3 a = glm::normalize(dvec3(corners[i]) - place),
                    b = glm::normalize(dvec3(corners[(i + 1) % 4]) - place);
        sum += std::acos(glm::dot(a, b)) * glm::normalize(glm::cross(a, b)).y;
    }
    return 0.5 * std::abs(sum);
}

TEST(Transport, AnEmissiveSquareLightsTheFloorByItsFormFactor)
{
    const std::array<vec3, 4> square = {vec3(-0.5f, 1, -0.5f), vec3(0.5f, 1, -0.5f), vec3(0.5f, 1, 0.5f),
                                        vec3(-0.5f, 1, 0.5f)}; // faces down
    const dvec3 place(0.3, 0.0, 0.2), rho(0.2, 0.5, 1.0), radiance(4.0, 2.0, 1.0);
    const dvec3 exact = rho * radiance / kPi * polygonIrradiance(place, square);
    struct Case
    {
        const char* name;
        bool turned, doubleSided, unlit;
        dvec3 exact;
        bool mirrored = false;
    };
    for (const Case& c : {Case{"front", false, false, false, exact},
                          {"back", true, false, false, dvec3(0.0)},
                          {"back of a double-sided one", true, true, false, exact},
                          {"unlit", false, false, true, exact},
                          {"of a node that mirrors", false, false, false, exact, true}})
    {
        Scene scene;
        Material light = material(dvec3(0.0)); // black: it reflects nothing back
        if (c.unlit)
            light.baseColorFactor = dvec4(radiance, 1.0);
        else
            light.emissiveFactor = radiance;
        light.unlit = c.unlit;
        light.doubleSided = c.doubleSided;
        std::array<vec3, 4> corners = square;
        if (c.turned)
            std::swap(corners[1], corners[3]);
        addQuad(scene, corners, addMaterial(scene, light));
        if (c.mirrored) // to where it is already; its front still faces down
            scene.instances.back().worldFromObject[0].x = -1.0;
        addFloor(scene, 0.0f, 5.0f, addMaterial(scene, material(rho)));
        const RayCaster caster(scene, dvec3(0.0));
        EXPECT_FALSE(Emitters(caster).dark()) << c.name << ": it is drawn from";
        for (const DirectionChoice choice : kChoices)
            EXPECT_TRUE(agrees(pixelOf(scene, overFloor(place), settingsOf(lambertPreset(), 1, choice), 4096).colors,
                               c.exact, 1e-12, 15))
                << c.name << ' ' << int(choice);
    }
}

TEST(Transport, WhatEmitsBetweenThePlacesThatWereLookedAtIsMetAllTheSame)
{
    // One texel of 256 is bright, and at none of the places: the square is not drawn from, and paths alone find it.
    Scene scene;
    Material source = material(dvec3(0.0));
    source.emissiveFactor = dvec3(1000.0);
    source.emissive.texture = 0;
    addFloor(scene, 1.0f, 0.5f, addMaterial(scene, source), false);
    addFloor(scene, 0.0f, 5.0f, addMaterial(scene, material(dvec3(1.0))));
    TextureImage image = {"spark", 16, 16, TexelFormat::rgba8, std::vector<std::byte>(4 * 256, std::byte(0))};
    scene.images.push_back(image);
    scene.textures.push_back({0, {.wrapS = Wrap::clampToEdge, .magnify = Filter::nearest}});
    const RayCaster caster(scene, dvec3(0.0));
    std::vector<std::byte>& texels = scene.images[0].texels;
    const auto onlyTexel = [&](int i) {
        std::ranges::fill(texels, std::byte(0));
        std::fill_n(texels.begin() + 4 * i, 4, std::byte(255));
        return Emitters(caster).dark();
    };
    int texel = 100;
    while (texel < 256 && !onlyTexel(texel))
        ++texel;
    ASSERT_LT(texel, 256);
    const auto light = [&](DirectionChoice choice) {
        return pixelOf(scene, overFloor(dvec3(0.0)), settingsOf(lambertPreset(), 1, choice), 65536).colors.mean();
    };
    EXPECT_GT(light(DirectionChoice::brdf).r, 0.0);
    EXPECT_EQ(light(DirectionChoice::brdf), light(DirectionChoice::combined));
    EXPECT_EQ(light(DirectionChoice::brdf), light(DirectionChoice::light));
}

TEST(Transport, ASphereLightsTheFloorOnceHoweverItIsFound)
{
    // Radiance I / (pi r^2), above the horizon as a whole: E = I cos / d^2, as of a point. Camera rays do not meet it.
    Scene scene;
    addFloor(scene, 0.0f, 5.0f, addMaterial(scene, material(dvec3(1.0))));
    scene.lights = {lamp(dvec3(0.5, 1.0, 0.0), 3.0, 0.4), lamp(dvec3(-1.0, 2.0, 0.0), 8.0, 0.5)};
    const double d2 = 1.25, e2 = 5.0;
    const dvec3 exact(3.0 / d2 / std::sqrt(d2) / kPi + 8.0 * 2.0 / e2 / std::sqrt(e2) / kPi);
    for (const DirectionChoice choice : kChoices)
        EXPECT_TRUE(agrees(pixelOf(scene, overFloor(dvec3(0.0)), settingsOf(lambertPreset(), 1, choice), 4096).colors,
                           exact, 1e-4, 3)) // the pixel's centre is within 1e-4 of the place
            << int(choice);
    const Camera intoTheLamp = lookAtCamera(dvec3(0.5, 1.0, 3.0), dvec3(0.5, 1.0, 0.0), dvec3(0, 1, 0), 0.01);
    EXPECT_EQ(PixelEstimator(scene, intoTheLamp, settingsOf(lambertPreset(), 1)).estimate(0, 0, 0.0).color, dvec4(0.0));
}

TEST(Transport, PathsEndWhereMoreIsReflectedThanArrives)
{
    // As colours of vertices may ask for it. What a path carries grows, so that kMostSurvival alone ends it.
    Scene scene;
    addCube(scene, 2.0, addMaterial(scene, material(dvec3(1.05))), true);
    const Camera camera = lookAtCamera(dvec3(0.3, -0.2, 0.4), dvec3(1.0, 0.7, -1.0), dvec3(0, 1, 0), 1.0);
    const PixelReplicates dark = pixelOf(scene, camera, settingsOf(lambertPreset(), 1), 64);
    EXPECT_EQ(dark.colors.mean(), dvec3(0.0));
}

TEST(Transport, DirectionsReachAllOfASurfaceThatIsNotWhatItIsTakenFor)
{
    // Of a smooth white metal all light is expected in the lobe; this one is Lambert's all the same: kLeastShare.
    Scene scene;
    addFloor(scene, 0.0f, 1.0f, addMaterial(scene, material(dvec3(1.0), 1.0, 0.1)));
    scene.environment = uniform(dvec3(2.0));
    for (const DirectionChoice choice : {DirectionChoice::combined, DirectionChoice::brdf}) {
        const Replicates light =
            pixelOf(scene, overFloor(dvec3(0.0)), settingsOf(lambertPreset(), 1, choice), 4096).colors;
        EXPECT_TRUE(agrees(light, dvec3(2.0), 0.0, 2)) << int(choice);
        // With a tenth of the cosine a path counts 20 at most and 2 on average: its variance is below 40.
        EXPECT_LT(light.variance().r, 2.0 * 40.0 / 4096) << int(choice);
    }
}

// --- Shadows --------------------------------------------------------------------------------------------------------

/// A white floor under a lamp at (0, 2, 0), a square of half side 0.5 at height 1 between them.
Scene shadowScene(const Material& blocker, bool up = true)
{
    Scene scene;
    addFloor(scene, 0.0f, 5.0f, addMaterial(scene, material(dvec3(0.8, 0.6, 0.4))));
    addFloor(scene, 1.0f, 0.5f, addMaterial(scene, blocker), up);
    scene.lights = {lamp(dvec3(0.0, 2.0, 0.0), 7.0)};
    return scene;
}

/// The square's shadow reaches to |x|, |z| = 1 on the floor.
dvec3 lightOnFloor(const Scene& scene, const dvec3& place, const brdf::Preset& methods)
{
    const PixelReplicates pixel = pixelOf(scene, overFloor(place), settingsOf(methods, 1), 64);
    for (const dvec3& value : pixel.colors.values)
        EXPECT_EQ(value, pixel.colors.values[0]) << "black reflects nothing back, so that nothing is random";
    return pixel.colors.values[0];
}

/// Without anything between: the BRDF at the same point.
dvec3 unshadowed(const dvec3& place, const brdf::Preset& methods)
{
    Scene scene = shadowScene(Material());
    scene.instances.pop_back();
    ReferenceSettings settings = settingsOf(methods, 1);
    settings.transport = false;
    return pixelOf(scene, overFloor(place), settings, 64).colors.mean();
}

TEST(Transport, APointLightIsBlockedOrAsBrightAsWithoutShadows)
{
    const brdf::Preset methods = lambertPreset();
    for (const bool up : {true, false}) { // both sides of a single-sided square block
        const Scene scene = shadowScene(material(dvec3(0.0)), up);
        for (const double x : {-0.95, 0.0, 0.7, 0.98})
            EXPECT_EQ(lightOnFloor(scene, {x, 0, 0.5}, methods), dvec3(0.0)) << x;
        for (const double x : {-1.5, -1.02, 1.02, 3.0}) {
            const dvec3 exact = unshadowed({x, 0, 0.5}, methods);
            EXPECT_LT(glm::length(lightOnFloor(scene, {x, 0, 0.5}, methods) - exact), 1e-12 * glm::length(exact)) << x;
        }
    }
    // What lies behind the lamp blocks nothing.
    Scene behind = shadowScene(material(dvec3(0.0)));
    behind.lights[0].position = dvec3(0.0, 0.9, 0.0);
    EXPECT_GT(lightOnFloor(behind, dvec3(0.0), methods).r, 0.0);
}

TEST(Transport, MaskedHolesLetLightThroughAndBlendedSurfacesTheirShare)
{
    const brdf::Preset methods = lambertPreset();
    Material half = material(dvec3(0.0)); // its left half is there
    half.alphaMode = AlphaMode::mask;
    half.baseColor.texture = 0;
    Scene scene = shadowScene(half);
    TextureImage image = {"half", 2, 1, TexelFormat::rgba8, {}};
    for (const int alpha : {255, 0})
        for (const int value : {255, 255, 255, alpha})
            image.texels.push_back(std::byte(value));
    scene.images.push_back(image);
    scene.textures.push_back({0, {.wrapS = Wrap::clampToEdge, .magnify = Filter::nearest}});
    EXPECT_EQ(lightOnFloor(scene, {-0.5, 0, 0}, methods), dvec3(0.0));
    const dvec3 exact = unshadowed({0.5, 0, 0}, methods);
    EXPECT_LT(glm::length(lightOnFloor(scene, {0.5, 0, 0}, methods) - exact), 1e-12 * glm::length(exact));

    Material pane = material(dvec3(0.0));
    pane.alphaMode = AlphaMode::blend;
    pane.baseColorFactor.a = 0.25;
    Scene blended = shadowScene(pane);
    EXPECT_LT(glm::length(lightOnFloor(blended, {0.5, 0, 0}, methods) - 0.75 * exact), 1e-12 * glm::length(exact));
    pane.baseColorFactor.a = 0.5;
    addFloor(blended, 1.2f, 1.0f, addMaterial(blended, pane));
    EXPECT_LT(glm::length(lightOnFloor(blended, {0.5, 0, 0}, methods) - 0.375 * exact), 1e-12 * glm::length(exact));
}

TEST(Transport, PathsGoThroughBlendedSurfacesAsOftenAsTheyLetLightThrough)
{
    // A floor of a cube whose walls are black and let three quarters through, in an even sky.
    Scene scene;
    Material walls = material(dvec3(0.0));
    walls.alphaMode = AlphaMode::blend;
    walls.baseColorFactor.a = 0.25;
    addCube(scene, 3.0, addMaterial(scene, walls));
    addFloor(scene, 0.0f, 1.0f, addMaterial(scene, material(dvec3(0.5, 1.0, 0.25))));
    scene.environment = uniform(dvec3(2.0));
    const Camera camera = lookAtCamera(dvec3(0.0, 1.0, 1.0), dvec3(0.0), dvec3(0, 1, 0), 0.01);
    for (const DirectionChoice choice : kChoices)
        EXPECT_TRUE(agrees(pixelOf(scene, camera, settingsOf(lambertPreset(), 1, choice), 65536).colors,
                           0.75 * 2.0 * dvec3(0.5, 1.0, 0.25), 0.0, 3))
            << int(choice);
}

/// Two tilted floors, the second `gap` above the first along their normal and facing away from the eye, so that it is
/// not drawn; a lamp above both. `place` is the world's origin as seen from them.
Scene twoSheets(double gap, const dvec3& place)
{
    Scene scene;
    const int white = addMaterial(scene, material(dvec3(1.0))), black = addMaterial(scene, material(dvec3(0.0)));
    addFloor(scene, 0.0f, 1.0f, white);
    addFloor(scene, 0.0f, 1.0f, black, false);
    const double c = std::cos(0.3), s = std::sin(0.3);
    const dmat4 tilt(dvec4(1, 0, 0, 0), dvec4(0, c, s, 0), dvec4(0, -s, c, 0), dvec4(place, 1));
    scene.instances[0].worldFromObject = scene.instances[1].worldFromObject = tilt;
    scene.instances[1].worldFromObject[3] += gap * tilt[1];
    scene.lights = {lamp(place + dvec3(0.0, 3.0, 0.0), 1.0)};
    return scene;
}

/// Pixels of 64 that are lit.
int litPixels(const Scene& scene, const dvec3& place)
{
    const Camera camera = lookAtCamera(place + dvec3(0.3, 6.1, 8.7), place, dvec3(0, 1, 0), 0.1);
    const ReferenceSettings settings = settingsOf(lambertPreset(), 8);
    const PixelEstimator estimator(scene, camera, settings);
    int lit = 0;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            lit += estimator.replicates(x, y, 64, 1).colors.mean().r > 0.0;
    return lit;
}

TEST(Transport, ASurfaceInTheSamePlaneThrowsNoShadowAndASheetAboveDoes)
{
    EXPECT_EQ(litPixels(twoSheets(0.0, dvec3(0.0)), dvec3(0.0)), 64);
    // A kilometre away from the world's origin, where doubles are 1e-13 apart.
    EXPECT_EQ(litPixels(twoSheets(0.0, dvec3(700.0, -300.0, 1000.0)), dvec3(700.0, -300.0, 1000.0)), 64);
    // Rays begin 2e-9 off; floats are 5e-7 apart here.
    for (const double gap : {1e-8, 1e-7, 1e-6})
        EXPECT_EQ(litPixels(twoSheets(gap, dvec3(0.0)), dvec3(0.0)), 0) << gap;
}

// --- Against each other ---------------------------------------------------------------------------------------------

/// A box of 2 m that is open towards +z, red on the left, green on the right, with two blocks; metal and dielectric.
Scene cornellBox()
{
    Scene scene;
    const int white = addMaterial(scene, material(dvec3(0.75), 0.0, 0.9));
    const int red = addMaterial(scene, material(dvec3(0.65, 0.06, 0.05), 0.0, 0.8));
    const int green = addMaterial(scene, material(dvec3(0.1, 0.45, 0.1), 0.0, 0.8));
    const int metal = addMaterial(scene, material(dvec3(0.9, 0.8, 0.6), 1.0, 0.4));
    addFloor(scene, -1.0f, 1.0f, white);
    addFloor(scene, 1.0f, 1.0f, white, false);
    addQuad(scene, {vec3(-1, -1, -1), vec3(1, -1, -1), vec3(1, 1, -1), vec3(-1, 1, -1)}, white);
    addQuad(scene, {vec3(-1, -1, 1), vec3(-1, -1, -1), vec3(-1, 1, -1), vec3(-1, 1, 1)}, red);
    addQuad(scene, {vec3(1, -1, -1), vec3(1, -1, 1), vec3(1, 1, 1), vec3(1, 1, -1)}, green);
    const auto block = [&](const dvec3& half, double turn, const dvec3& place, int material) {
        addCube(scene, 1.0, material);
        const double c = std::cos(turn), s = std::sin(turn);
        scene.instances.back().worldFromObject = dmat4(dvec4(half.x * c, 0, -half.x * s, 0), dvec4(0, half.y, 0, 0),
                                                       dvec4(half.z * s, 0, half.z * c, 0), dvec4(place, 1.0));
    };
    block(dvec3(0.3), -0.3, dvec3(0.35, -0.7, 0.3), white);
    block(dvec3(0.3, 0.6, 0.3), 0.35, dvec3(-0.35, -0.4, -0.3), metal);
    return scene;
}

const Camera kBoxCamera = lookAtCamera(dvec3(0.0, 0.0, 4.6), dvec3(0.0), dvec3(0, 1, 0), 0.6);

enum class BoxLight
{
    sphere,
    square,
    environment,
    all,
};

Scene litBox(BoxLight light)
{
    Scene scene = cornellBox();
    if (light == BoxLight::sphere || light == BoxLight::all)
        scene.lights = {lamp(dvec3(0.2, 0.6, 0.1), 2.0, 0.25)};
    if (light == BoxLight::square || light == BoxLight::all) {
        Material source = material(dvec3(0.0));
        source.emissiveFactor = dvec3(8.0, 6.0, 4.0);
        addFloor(scene, 0.98f, 0.35f, addMaterial(scene, source), false);
    }
    if (light == BoxLight::environment || light == BoxLight::all) {
        scene.environment = uniform(dvec3(0.5, 0.7, 1.0));
        std::fill_n(scene.environment->radiance.at(2, 1), 3, 6.0f); // some sky is bright
    }
    return scene;
}

class TransportBox : public ::testing::TestWithParam<BoxLight>
{
};

TEST_P(TransportBox, IsTheSameHoweverLightsAreFound)
{
    const Scene scene = litBox(GetParam());
    const brdf::Preset& standard = *brdf::findPreset("standard");
    const auto mean = [&](DirectionChoice choice, int paths) {
        return meanOf(scene, kBoxCamera, settingsOf(standard, 12, choice), paths, std::uint64_t(choice));
    };
    const Replicates combined = mean(DirectionChoice::combined, 128);
    const Replicates withoutDraws = mean(DirectionChoice::brdf, 1024), byDraws = mean(DirectionChoice::light, 256);
    EXPECT_GT(combined.mean().g, 0.05) << "it is lit";
    EXPECT_LT(halfWidth95(difference(combined, withoutDraws).variance()), 0.05 * (combined.mean().g * 3.0))
        << "an error of the fifth part of a bounce would show";
    EXPECT_TRUE(agrees(difference(combined, withoutDraws), dvec3(0.0), 0.0, 8)) << "brdf";
    EXPECT_TRUE(agrees(difference(combined, byDraws), dvec3(0.0), 0.0, 8)) << "light";
}

INSTANTIATE_TEST_SUITE_P(Lights, TransportBox,
                         ::testing::Values(BoxLight::sphere, BoxLight::square, BoxLight::environment, BoxLight::all));

TEST(Transport, OfOneConvexBodyIsTheIntegralOfItsSurface)
{
    // Nothing is in reach, so that shadows and interreflection are none: lamp, sphere and sky, occluded by none.
    Scene scene = litBox(BoxLight::all);
    scene.primitives.clear();
    scene.instances.clear();
    for (const double metallic : {0.0, 1.0}) {
        const int m = addMaterial(scene, material(dvec3(0.9, 0.5, 0.2), metallic, 0.4));
        scene.primitives.clear();
        scene.instances.clear();
        addCube(scene, 0.5, m);
        scene.lights = {lamp(dvec3(1.0, 2.0, 2.5), 10.0), lamp(dvec3(2.0, 1.0, 1.0), 5.0, 0.3)};
        const Camera camera = lookAtCamera(dvec3(1.5, 1.2, 2.0), dvec3(0.0), dvec3(0, 1, 0), 0.5);
        ReferenceSettings with = settingsOf(*brdf::findPreset("standard"), 8), without = with;
        without.transport = false;
        const PixelEstimator traced(scene, camera, with), integrated(scene, camera, without);
        int seen = 0;
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) {
                const PixelReplicates a = traced.replicates(x, y, 1024, 1), b = integrated.replicates(x, y, 1024, 2);
                EXPECT_TRUE(agrees(difference(a.colors, b.colors), dvec3(0.0), 1e-6, 128)) << x << ' ' << y;
                seen += integrated.seenFrom(x, y).has_value();
            }
        EXPECT_GT(seen, 20);
    }
}

TEST(Transport, PhysicsAgreesWithItselfOverOneSurface)
{
    Scene scene;
    addCube(scene, 0.5, addMaterial(scene, material(dvec3(0.9, 0.5, 0.2), 0.5, 0.4)));
    scene.lights = {lamp(dvec3(1.0, 2.0, 2.5), 10.0)};
    scene.environment = uniform(dvec3(0.5, 0.7, 1.0));
    const Camera camera = lookAtCamera(dvec3(1.5, 1.2, 2.0), dvec3(0.0), dvec3(0, 1, 0), 0.5);
    ReferenceSettings with = settingsOf(*brdf::findPreset("standard"), 3);
    with.physics = true;
    ReferenceSettings without = with;
    without.transport = false;
    EXPECT_TRUE(agrees(difference(meanOf(scene, camera, with, 1024, 1), meanOf(scene, camera, without, 1024, 2)),
                       dvec3(0.0), 0.0, 1));
}

// --- What does not count --------------------------------------------------------------------------------------------

TEST(Transport, OcclusionTexturesStandForWhatPathsFindAndDoNotCount)
{
    Scene scene = litBox(BoxLight::environment);
    const auto picture = [&] {
        return meanOf(scene, kBoxCamera, settingsOf(*brdf::findPreset("gltf"), 4), 64, 3).mean();
    };
    const dvec3 open = picture();
    scene.images.push_back({"dark", 1, 1, TexelFormat::rgba8, std::vector<std::byte>(4, std::byte(0))});
    scene.textures.push_back({0, {}});
    for (Material& m : scene.materials)
        m.occlusion.texture = 0;
    EXPECT_EQ(picture(), open);
}

TEST(Transport, LightFromBelowTheSurfaceDoesNotArriveWhateverTheShadingNormal)
{
    // A floor whose vertex normals lean towards a lamp below its plane.
    Scene scene;
    addFloor(scene, 0.0f, 1.0f, addMaterial(scene, material(dvec3(1.0))));
    scene.primitives[0].normals.assign(4, glm::normalize(vec3(1.0f, 0.5f, 0.0f)));
    scene.lights = {lamp(dvec3(3.0, -0.5, 0.0), 10.0)};
    ReferenceSettings settings = settingsOf(lambertPreset(), 1);
    EXPECT_EQ(pixelOf(scene, overFloor(dvec3(0.0)), settings, 64).colors.mean(), dvec3(0.0));
    settings.transport = false; // the renderer knows the shading normal alone
    EXPECT_GT(pixelOf(scene, overFloor(dvec3(0.0)), settings, 64).colors.mean().r, 0.0);
    scene.lights.clear();
    scene.environment = uniform(dvec3(1.0)); // from below the floor, too
    settings.transport = true;
    const dvec3 sky = pixelOf(scene, overFloor(dvec3(0.0)), settings, 4096).colors.mean();
    // Of the cosine's hemisphere about a normal that leans by t, the part above the floor is (1 + cos t) / 2.
    EXPECT_NEAR(sky.r, 0.5 * (1.0 + 1.0 / std::sqrt(5.0)), 0.01);
}

} // namespace
} // namespace torrance
