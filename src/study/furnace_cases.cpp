#include "study/furnace_cases.h"

#include "reference/pixel_condition.h"
#include "scene/camera_fit.h"
#include "study/analytic_scenes.h"

#include <cmath>
#include <fmt/format.h>
#include <functional>

namespace torrance {
namespace {

constexpr double kTolerance = 2e-3; // of white: the prefiltered light and the table of albedos are approximations
constexpr double kLeastNoV = 0.05;
constexpr int kSize = 20;
constexpr int kLeastCompared = 250; // of 400 pixels

constexpr double kRoughnesses[] = {0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 0.85, 1.0};

/// The camera's rays meet a sphere at n.v = 1 in the middle and 0 at the silhouette.
Scene furnaceScene(double metallic, double roughness)
{
    Scene scene;
    scene.materials.push_back(plainMaterial(dvec3(1.0), metallic, roughness));
    scene.shapes.push_back(
        {.kind = AnalyticShape::Kind::sphere, .material = 0, .worldFromObject = dmat4(1.0), .name = "ball"});
    scene.environment = uniformEnvironment(dvec3(1.0));
    return scene;
}

double cosineOfView(const PixelInputs& inputs)
{
    const dvec3 direction = glm::normalize(inputs.ray.direction);
    const dvec3 center(inputs.shape.worldFromObject[3]);
    const double apart2 = glm::dot(center, center) - glm::dot(center, direction) * glm::dot(center, direction);
    return apart2 < 1.0 ? std::sqrt(1.0 - apart2) : 0.0;
}

using Exact = std::function<double(const PixelInputs&)>;

PictureJudgement judgeFurnace(const PictureCase& c, const Image& drawn, const Exact& exact)
{
    PictureJudgement judgement{
        .worst = {}, .fault = {}, .exact = Image(kSize, kSize, 4), .excess = Image(kSize, kSize, 1)};
    int compared = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const PixelInputs inputs = pixelInputs(c.scene, 0, c.camera, kSize, kSize, x, y);
            if (cosineOfView(inputs) < kLeastNoV)
                continue;
            ++compared;
            const dvec3 radiance(exact(inputs));
            for (int k = 0; k < 4; ++k)
                judgement.exact.at(x, y)[k] = k == 3 ? 1.0f : static_cast<float>(radiance[k]);
            const float* p = drawn.at(x, y);
            *judgement.excess.at(x, y) =
                static_cast<float>(judgement.worst.note(x, y, dvec3(p[0], p[1], p[2]), radiance, dvec3(kTolerance)));
        }
    if (compared <= kLeastCompared)
        judgement.fault = fmt::format("only {} pixels to compare", compared);
    return judgement;
}

} // namespace

std::vector<PictureCase> furnaceCases(const brdf::Preset& methods, std::string_view name, double metallic)
{
    Exact exact = [methods](const PixelInputs& inputs) { return pixelRadiance(methods, inputs).value().r; };
    if (metallic == 1.0 && methods.multipleScattering->readsAlbedo)
        exact = [](const PixelInputs&) { return 1.0; };
    std::vector<PictureCase> cases;
    for (const double roughness : kRoughnesses) {
        Scene scene = furnaceScene(metallic, roughness);
        const Camera camera = fitCamera(scene, {}, 1.0, 0.5, 0.02);
        cases.push_back({fmt::format("{}, metallic {}, roughness {}", name, metallic, roughness), std::move(scene),
                         camera, squareSettings(methods, kSize),
                         [exact](const PictureCase& c, const Image& drawn) { return judgeFurnace(c, drawn, exact); }});
    }
    return cases;
}

std::vector<PictureCase> furnaceCases(std::string_view preset, double metallic)
{
    return furnaceCases(*brdf::findPreset(preset), preset, metallic);
}

} // namespace torrance
