// Analytic shapes under every light, pixel by pixel against the double formulas: |drawn - c| <= 1e-4 |c| + 1e-6 max |c|
// + what the rounding of the pixel's own inputs may change.
#include "drawing.h"
#include "reference/pixel_condition.h"
#include "scene/camera_fit.h"
#include "scenes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <optional>

namespace torrance::test {
namespace {

constexpr double kRelative = 1e-4;
constexpr double kOfBrightest = 1e-6;

/// As for a BRDF (issue of foundation: 2 kappa 2^-24): inputs are rounded once on the way in and once on the way
/// through.
constexpr double kConditionFactor = 2.0;

struct PixelTruth
{
    std::optional<dvec3> radiance; // nothing: the ray misses
    bool decided = true;           // no rounding changes whether it does
    dvec3 condition = dvec3(0.0);
};

std::vector<PixelTruth> truthOf(const Scene& scene, const brdf::Preset& methods, const Camera& camera, int size)
{
    std::vector<PixelTruth> truth;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const PixelInputs inputs = pixelInputs(scene, 0, camera, size, size, x, y);
            PixelTruth pixel{pixelRadiance(methods, inputs), coverageIsDecided(inputs)};
            if (pixel.radiance && pixel.decided)
                pixel.condition = pixelCondition(methods, inputs);
            truth.push_back(pixel);
        }
    return truth;
}

double brightest(const std::vector<PixelTruth>& truth)
{
    double most = 0.0;
    for (const PixelTruth& t : truth)
        if (t.radiance)
            most = std::max({most, t.radiance->r, t.radiance->g, t.radiance->b});
    return most;
}

Image exactPicture(const std::vector<PixelTruth>& truth, int size)
{
    Image image(size, size, 4);
    for (int i = 0; i < size * size; ++i)
        if (const auto& c = truth[static_cast<std::size_t>(i)].radiance)
            for (int k = 0; k < 4; ++k)
                image.at(i % size, i / size)[k] = k == 3 ? 1.0f : static_cast<float>((*c)[k]);
    return image;
}

void expectDrawnAsComputed(const Scene& scene, std::string_view preset, int size, const std::string& name)
{
    const Camera camera = fitCamera(scene, {0.3, 1.3}, 1.0, 0.7, 0.15);
    const Settings settings = settingsOf(preset, size);
    const Picture picture = draw(scene, camera, settings);
    const std::vector<PixelTruth> truth = truthOf(scene, plannedMethods(scene, settings, 0), camera, size);
    const double floor = kOfBrightest * brightest(truth);
    Worst worst;
    int covered = 0;
    int undecided = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const PixelTruth& t = truth[static_cast<std::size_t>(y * size + x)];
            const dvec4 drawn = pixelOf(picture, x, y);
            undecided += t.decided ? 0 : 1;
            if (!t.decided)
                continue;
            EXPECT_EQ(drawn.a, t.radiance ? 1.0 : 0.0) << name << " coverage at " << x << ", " << y;
            if (!t.radiance)
                continue;
            ++covered;
            worst.note(x, y, dvec3(drawn), *t.radiance,
                       kRelative * glm::abs(*t.radiance) + floor + kConditionFactor * t.condition);
        }
    EXPECT_GT(covered, size * size / 4) << name;
    EXPECT_LE(undecided, size / 4) << name << ": coverage hangs on a rounding";
    EXPECT_GT(brightest(truth), 0.01) << name << ": nothing is lit";
    EXPECT_LE(worst.excess, 1.0) << name << ' ' << preset << ": " << worst.text() << "; see "
                                 << keepFailure(name, picture.color, exactPicture(truth, size));
}

const dvec3 kGold(1.0, 0.77, 0.34);

const Material kMaterials[] = {
    plainMaterial(kGold, 1.0, 0.1),
    plainMaterial(kGold, 1.0, 0.6),
    plainMaterial(dvec3(0.8, 0.1, 0.2), 0.0, 0.25),
    plainMaterial(dvec3(0.02, 0.5, 0.9), 0.5, 1.0),
};

void expectAllMaterials(AnalyticShape::Kind shape, Light::Kind light, const std::string& name)
{
    for (const Material& material : kMaterials)
        for (const char* preset : {"gltf", "standard"}) {
            Scene scene = shapeScene(shape, material);
            scene.lights.push_back(testLight(light));
            // the exact albedo behind `standard` costs more than all the rest: fewer pixels
            const int size = std::string_view(preset) == "gltf" ? 48 : 16;
            expectDrawnAsComputed(scene, preset, size, name);
        }
}

void expectAllMaterialsInTheFurnace(AnalyticShape::Kind shape, const std::string& name)
{
    for (const Material& material : kMaterials)
        for (const char* preset : {"gltf", "standard"}) {
            Scene scene = shapeScene(shape, material);
            scene.environment = uniformEnvironment(dvec3(0.9, 1.0, 1.2));
            expectDrawnAsComputed(scene, preset, 16, name);
        }
}

using Shape = AnalyticShape::Kind;

TEST(SphereImage, DirectionalLight)
{
    expectAllMaterials(Shape::sphere, Light::Kind::directional, "sphere-directional");
}

TEST(SphereImage, PointLight)
{
    expectAllMaterials(Shape::sphere, Light::Kind::point, "sphere-point");
}

TEST(SphereImage, SpotLight)
{
    expectAllMaterials(Shape::sphere, Light::Kind::spot, "sphere-spot");
}

TEST(SphereImage, UniformEnvironment)
{
    expectAllMaterialsInTheFurnace(Shape::sphere, "sphere-uniform");
}

TEST(PlaneImage, DirectionalLight)
{
    expectAllMaterials(Shape::plane, Light::Kind::directional, "plane-directional");
}

TEST(PlaneImage, PointLight)
{
    expectAllMaterials(Shape::plane, Light::Kind::point, "plane-point");
}

TEST(PlaneImage, SpotLight)
{
    expectAllMaterials(Shape::plane, Light::Kind::spot, "plane-spot");
}

TEST(PlaneImage, UniformEnvironment)
{
    expectAllMaterialsInTheFurnace(Shape::plane, "plane-uniform");
}

} // namespace
} // namespace torrance::test
