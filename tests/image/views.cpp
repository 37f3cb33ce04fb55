// Every term that can be viewed, on a sphere: each pixel is the term's double formula, within 1e-4 of it, a millionth
// of the picture's greatest value and what the rounding of the pixel's own inputs may change.
#include "drawing.h"

#include "brdf/brdf.h"
#include "brdf/dfg.h"
#include "reference/pixel_condition.h"
#include "scene/camera_fit.h"
#include "study/analytic_scenes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <optional>

namespace torrance::test {
namespace {

constexpr int kSize = 20;

// What surfaces and one light have.
dvec3 lightValue(std::string_view id, const brdf::Preset& preset, const PixelSurface& surface, const LightSample& light)
{
    brdf::ShadingPoint point = brdf::makeShadingPoint(surface.material.normal, surface.view, light.direction,
                                                      surface.material.perceptualRoughness);
    point.baseColor = surface.material.baseColor;
    point.metallic = surface.material.metallic;
    const brdf::BrdfTerms terms = brdf::evaluateTerms(preset, point);
    const std::map<std::string_view, dvec3> values = {{"light_intensity", light.irradiance},
                                                      {"half_vector", terms.h},
                                                      {"n_dot_l", dvec3(std::max(point.NoL, 0.0))},
                                                      {"D", dvec3(terms.D)},
                                                      {"G1", dvec3(terms.G1)},
                                                      {"G", dvec3(terms.G)},
                                                      {"V", dvec3(terms.V)},
                                                      {"F0", terms.F0},
                                                      {"F", terms.F},
                                                      {"specular", terms.specular},
                                                      {"diffuse", terms.diffuse},
                                                      {"brdf", terms.brdf}};
    return values.at(id);
}

std::optional<dvec3> valueOf(const View& view, const brdf::Preset& preset, const PixelInputs& inputs)
{
    const std::optional<PixelSurface> surface = pixelSurface(inputs);
    if (!surface)
        return std::nullopt;
    if (view.id == "albedo")
        return surface->material.baseColor;
    if (view.id == "roughness")
        return dvec3(surface->material.perceptualRoughness);
    if (view.id == "metallic")
        return dvec3(surface->material.metallic);
    const LightSample light = sampleLight(inputs.lights.front(), dvec3(0.0), surface->position);
    return lightValue(view.id, preset, *surface, light);
}

void expectViewAsComputed(const View& view, const brdf::Preset& preset)
{
    SCOPED_TRACE(std::string(preset.id) + ' ' + std::string(view.id));
    Scene scene = shapeScene(AnalyticShape::Kind::sphere, plainMaterial(dvec3(0.9, 0.4, 0.2), 0.3, 0.35));
    scene.lights.push_back(testLight(Light::Kind::point));
    const Camera camera = fitCamera(scene, {0.3, 1.3}, 1.0, 0.7, 0.15);
    Settings settings = squareSettings(preset, kSize);
    settings.view = &view;
    const Picture picture = draw(scene, camera, settings);
    const double greatest = static_cast<double>(*std::ranges::max_element(picture.color.texels));
    const PixelFormula formula = [&](const PixelInputs& p) { return valueOf(view, preset, p); };
    WorstExcess worst;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const PixelInputs inputs = pixelInputs(scene, 0, camera, kSize, kSize, x, y);
            const std::optional<dvec3> exact = formula(inputs);
            if (!exact || !coverageIsDecided(inputs))
                continue;
            worst.note(x, y, dvec3(pixelOf(picture, x, y)), *exact,
                       1e-4 * glm::abs(*exact) + 1e-6 * greatest + 2.0 * pixelCondition(formula, inputs));
        }
    EXPECT_LE(worst.excess, 1.0) << worst.text();
    EXPECT_GT(greatest, 0.0);
}

class ViewImage : public testing::TestWithParam<const brdf::Preset*>
{
};

TEST_P(ViewImage, OfEveryTermIsItsDoubleFormula)
{
    const brdf::Preset& preset = *GetParam();
    for (const View& view : allViews()) {
        const bool everywhere = view.subject == ViewSubject::surface || view.subject == ViewSubject::light;
        if (everywhere || (view.subject == ViewSubject::model && preset.model->id != "phong"))
            expectViewAsComputed(view, preset);
    }
}

std::vector<const brdf::Preset*> presetsWithoutCompensation()
{
    std::vector<const brdf::Preset*> presets;
    for (const brdf::Preset& preset : brdf::allPresets())
        if (preset.id != "standard") // gltf, but for an albedo that a table gives
            presets.push_back(&preset);
    return presets;
}

INSTANTIATE_TEST_SUITE_P(Views, ViewImage, testing::ValuesIn(presetsWithoutCompensation()), [](const auto& instance) {
    std::string name(instance.param->id);
    std::ranges::replace(name, '-', '_');
    return name;
});

// In an environment of radiance 1, irradiance is pi and what is prefiltered is 1, whatever the direction.
TEST(ViewImage, OfTheEnvironmentInAFurnace)
{
    Scene scene = shapeScene(AnalyticShape::Kind::sphere, plainMaterial(dvec3(0.9, 0.4, 0.2), 0.3, 0.35));
    scene.environment = uniformEnvironment(dvec3(1.0, 0.5, 0.25));
    scene.environment->intensity = 2.0;
    const Camera camera = fitCamera(scene, {0.3, 1.3}, 1.0, 0.7, 0.15);
    const auto center = [&](const char* preset, const char* id) {
        Settings settings = settingsOf(preset, kSize);
        settings.view = findView(id);
        return dvec3(pixelOf(draw(scene, camera, settings), kSize / 2, kSize / 2));
    };
    const dvec3 radiance(2.0, 1.0, 0.5);
    for (const char* preset : {"gltf", "ggx-burley"})
        EXPECT_LT(glm::length(center(preset, "irradiance") - kPi * radiance), 1e-5) << preset;
    for (const char* preset : {"gltf", "ggx-burley", "phong"})
        EXPECT_LT(glm::length(center(preset, "prefiltered") - radiance), 1e-5) << preset;
}

// The table is linear between its nodes: within 1e-4 of the integrals' sums (src/prepare/dfg_table.h).
TEST(ViewImage, OfTheDirectionalAlbedoIsTheTables)
{
    const Scene scene = shapeScene(AnalyticShape::Kind::sphere, plainMaterial(dvec3(0.9, 0.4, 0.2), 0.3, 0.35));
    const Camera camera = fitCamera(scene, {0.3, 1.3}, 1.0, 0.7, 0.15);
    Settings settings = settingsOf("gltf", kSize);
    settings.view = findView("dfg");
    const Picture picture = draw(scene, camera, settings);
    const PixelInputs inputs = pixelInputs(scene, 0, camera, kSize, kSize, kSize / 2, kSize / 2);
    const PixelSurface surface = pixelSurface(inputs).value();
    const dvec3 exact = brdf::DFG_table(glm::dot(surface.material.normal, surface.view), 0.35);
    EXPECT_LT(glm::length(dvec3(pixelOf(picture, kSize / 2, kSize / 2)) - exact), 2e-4);
}

} // namespace
} // namespace torrance::test
