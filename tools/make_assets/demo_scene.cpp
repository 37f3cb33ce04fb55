#include "make_assets/demo_scene.h"

#include "make_assets/demo_materials.h"
#include "make_assets/noise.h"
#include "make_assets/shapes.h"

#include <array>
#include <cmath>

namespace torrance::assets {
namespace {

constexpr double kPlinthRadius = 1.12; // metres; its top is y = 0
constexpr double kPlinthHeight = 0.14;
constexpr double kPlinthFlat = kPlinthRadius - 0.03; // where the rounding of its edge begins
constexpr double kDegree = kPi / 180.0;

DemoObject object(const std::string& name, Finish finish, std::vector<DemoPart> parts, const dvec3& translation,
                  double turnDegrees = 0.0)
{
    return {.name = name,
            .material = static_cast<int>(finish),
            .parts = std::move(parts),
            .translation = translation,
            .turn = turnDegrees * kDegree};
}

/// The side of the plinth, with uv that go on from its top's (x, z) as if it were unrolled.
Surface plinthSide()
{
    const Profile profile = roundedProfile({dvec2(kPlinthFlat, -kPlinthHeight), dvec2(kPlinthRadius, -kPlinthHeight),
                                            dvec2(kPlinthRadius, 0.0), dvec2(kPlinthFlat, 0.0)},
                                           0.02, 6);
    Surface side = lathe(profile, 160);
    const double length = profile.back().length;
    side.at = [length, round = side.at](double u, double v) {
        SurfacePoint point = round(u, v);
        const double turn = 2.0 * kPi * u;
        point.uv = (kPlinthFlat + v * length) * dvec2(std::sin(turn), std::cos(turn));
        return point;
    };
    return side;
}

std::vector<DemoPart> boxParts(const dvec3& halfSize, double radius)
{
    std::vector<DemoPart> parts;
    for (Surface& face : roundedBox(halfSize, radius, 5))
        parts.push_back({std::move(face), 40, 40});
    return parts;
}

/// The clock: its front face shows the whole of the numerals, its others a dark corner of them.
std::vector<DemoPart> clockParts(const dvec3& halfSize, double radius)
{
    std::vector<DemoPart> parts = boxParts(halfSize, radius);
    for (std::size_t face = 0; face < parts.size(); ++face)
        parts[face].surface.at = [face, plain = parts[face].surface.at](double u, double v) {
            SurfacePoint point = plain(u, v);
            point.uv = face == 0 ? dvec2(u, v) : dvec2(0.01, 0.01);
            return point;
        };
    return parts;
}

Surface vase()
{
    return lathe(smoothProfile({{0.0, 0.0},
                                {0.07, 0.0},
                                {0.125, 0.006},
                                {0.165, 0.06},
                                {0.225, 0.22},
                                {0.235, 0.36},
                                {0.185, 0.50},
                                {0.105, 0.60},
                                {0.070, 0.68},
                                {0.066, 0.76},
                                {0.088, 0.815},
                                {0.094, 0.823},
                                {0.090, 0.830},
                                {0.080, 0.822},
                                {0.054, 0.75},
                                {0.056, 0.60}},
                               7),
                 80);
}

/// A cylinder with rounded edges, from y = 0.
Surface cylinder(double radius, double height, double rounding, int columns)
{
    return lathe(roundedProfile({{0.0, 0.0}, {radius, 0.0}, {radius, height}, {0.0, height}}, rounding, 5), columns);
}

void addBackdrop(std::vector<DemoObject>& objects)
{
    objects.push_back(object("sweep", Finish::paper, {{sweep(5.0, 4.5, -2.6, 1.3, 4.5), 192, 192, 6}},
                             dvec3(0.0, -kPlinthHeight, 0.0)));
    objects.push_back(
        object("plinth", Finish::terrazzo, {{disc(kPlinthFlat, 32), 224, 224}, {plinthSide(), 128, 16}}, dvec3(0.0)));
}

void addLantern(std::vector<DemoObject>& objects, const dvec3& place)
{
    const double radius = 0.135;
    objects.push_back(
        object("lantern foot", Finish::brass, {{cylinder(radius + 0.012, 0.035, 0.010, 64), 48, 24}}, place));
    DemoObject screen = object("lantern screen", Finish::brassScreen,
                               {{lathe(roundedProfile({{radius, 0.0}, {radius, 0.36}}, 0.0, 1), 64), 48, 32}},
                               place + dvec3(0.0, 0.030, 0.0));
    screen.castsShadow = false;
    objects.push_back(std::move(screen));
    objects.push_back(object("lantern rim", Finish::brass,
                             {{lathe(roundedProfile({{radius - 0.012, 0.0},
                                                     {radius + 0.008, 0.0},
                                                     {radius + 0.008, 0.022},
                                                     {radius - 0.012, 0.022},
                                                     {radius - 0.012, 0.0}},
                                                    0.004, 3),
                                     64),
                               48, 16}},
                             place + dvec3(0.0, 0.382, 0.0)));
    objects.push_back(object("lamp", Finish::lamp,
                             {{superellipsoid(dvec3(0.075, 0.10, 0.075), 1.0, 1.0, 48, 32), 24, 24}},
                             place + dvec3(0.0, 0.165, 0.0)));
}

/// A stem with pairs of leaves that turn about it.
void addBranch(std::vector<DemoObject>& objects, const dvec3& root, const std::array<dvec3, 4>& curve, int pairs,
               std::uint32_t seed)
{
    objects.push_back(object("branch", Finish::bark, {{stem(curve, 0.0085, 0.0035, 10, 40), 16, 48}}, root));
    std::vector<DemoPart> leaves;
    for (int i = 0; i < 2 * pairs; ++i) {
        const double t = 0.42 + 0.56 * (i / 2) / (pairs - 0.7);
        const double s = 1.0 - t;
        const dvec3 place =
            s * s * s * curve[0] + 3.0 * s * s * t * curve[1] + 3.0 * s * t * t * curve[2] + t * t * t * curve[3];
        const double around = (90.0 * (i / 2) + 180.0 * (i % 2) + 50.0 * randomValue(i, 0, seed)) * kDegree;
        const dvec3 along = glm::normalize(curve[3] - curve[0]);
        const dvec3 out(std::cos(around), 0.15, std::sin(around));
        const dvec3 direction = glm::normalize(out + (0.35 + 0.9 * t * t) * along);
        const double size = (0.155 - 0.06 * t) * (0.85 + 0.3 * randomValue(i, 1, seed));
        leaves.push_back(
            {leaf(place, direction, glm::normalize(along + dvec3(0.0, 0.3, 0.25)), size, 0.62 * size, 0.35), 12, 16});
    }
    DemoObject foliage = object("leaves", Finish::leaf, std::move(leaves), root);
    foliage.castsShadow = false;
    objects.push_back(std::move(foliage));
}

void addVase(std::vector<DemoObject>& objects, const dvec3& place)
{
    objects.push_back(object("vase", Finish::glaze, {{vase(), 96, 96}}, place));
    addBranch(objects, place,
              {dvec3(0.0, 0.62, 0.0), dvec3(0.03, 0.95, 0.0), dvec3(-0.10, 1.15, 0.06), dvec3(-0.32, 1.33, 0.10)}, 7,
              101);
    addBranch(objects, place,
              {dvec3(0.01, 0.62, 0.01), dvec3(-0.02, 0.95, 0.02), dvec3(0.10, 1.20, -0.02), dvec3(0.24, 1.42, 0.04)}, 7,
              102);
}

void addHero(std::vector<DemoObject>& objects, const dvec3& place)
{
    const dvec3 half(0.21, 0.15, 0.21);
    objects.push_back(object("block", Finish::walnut, boxParts(half, 0.018), place + dvec3(0.0, half.y, 0.0), 24.0));
    objects.push_back(object("knot", Finish::gold, {{torusKnot(2, 3, 0.155, 0.072, 0.047, 28, 360), 48, 192}},
                             place + dvec3(0.0, 2.0 * half.y + 0.262, 0.0), -12.0));
}

} // namespace

DemoScene demoScene()
{
    std::vector<DemoObject> objects;
    addBackdrop(objects);
    addVase(objects, dvec3(-0.36, 0.0, -0.34));
    addHero(objects, dvec3(0.40, 0.0, -0.26));
    addLantern(objects, dvec3(-0.80, 0.0, 0.06));

    DemoObject sphere =
        object("copper ball", Finish::hammeredCopper, {{superellipsoid(dvec3(0.19), 1.0, 1.0, 96, 64), 64, 64}},
               dvec3(-0.17, 0.19, 0.30), 35.0);
    sphere.writesTangents = true;
    objects.push_back(std::move(sphere));
    objects.push_back(object("clock", Finish::clockFace, clockParts(dvec3(0.25, 0.125, 0.10), 0.022),
                             dvec3(0.42, 0.125, 0.36), -14.0));
    objects.push_back(object("coral pebble", Finish::coralPlastic,
                             {{superellipsoid(dvec3(0.15, 0.095, 0.15), 0.55, 0.7, 96, 56), 64, 48}},
                             dvec3(-0.56, 0.095, 0.50), 20.0));
    objects.push_back(object("ivory egg", Finish::ivoryCeramic,
                             {{superellipsoid(dvec3(0.085, 0.115, 0.085), 1.0, 0.9, 64, 40), 48, 48}},
                             dvec3(0.845, 0.115, 0.16)));
    objects.push_back(object("steel cylinder", Finish::brushedSteel, {{cylinder(0.085, 0.34, 0.012, 72), 64, 48}},
                             dvec3(0.80, 0.0, -0.16)));
    objects.push_back(object("chrome ball", Finish::chrome, {{superellipsoid(dvec3(0.062), 1.0, 1.0, 64, 40), 32, 32}},
                             dvec3(0.06, 0.062, 0.62)));
    objects.push_back(object("small gold ball", Finish::gold,
                             {{superellipsoid(dvec3(0.040), 1.0, 1.0, 48, 32), 24, 24}}, dvec3(-0.22, 0.040, 0.70)));
    DemoObject glass =
        object("glass", Finish::amberGlass, boxParts(dvec3(0.20, 0.29, 0.012), 0.010), dvec3(0.03, 0.29, -0.10), 28.0);
    glass.castsShadow = false;
    objects.push_back(std::move(glass));
    return {
        demoMaterials(), std::move(objects), {dvec3(0.0, 1.25, 5.3), dvec3(0.0, 0.42, 0.0), 24.0 * kDegree, 4.0 / 3.0}};
}

dvec3 turned(const DemoObject& object, const dvec3& direction)
{
    const double c = std::cos(object.turn);
    const double s = std::sin(object.turn);
    return dvec3(c * direction.x + s * direction.z, direction.y, -s * direction.x + c * direction.z);
}

dvec3 placed(const DemoObject& object, const dvec3& position)
{
    return turned(object, position) + object.translation;
}

} // namespace torrance::assets
