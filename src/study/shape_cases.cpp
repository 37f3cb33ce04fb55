#include "study/shape_cases.h"

#include "core/parallel.h"
#include "reference/pixel_condition.h"
#include "scene/camera_fit.h"
#include "study/analytic_scenes.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

namespace torrance {
namespace {

// |drawn - c| <= 1e-4 |c| + 1e-6 max |c| + what the rounding of the pixel's own inputs may change.
constexpr double kRelative = 1e-4;
constexpr double kOfBrightest = 1e-6;

/// As for a BRDF (2 kappa 2^-24): inputs are rounded once on the way in and once on the way through.
constexpr double kConditionFactor = 2.0;

struct PixelTruth
{
    std::optional<dvec3> radiance; // nothing: the ray misses
    bool decided = true;           // no rounding changes whether it does
    dvec3 condition = dvec3(0.0);
};

std::vector<PixelTruth> truthOf(const PictureCase& c)
{
    const brdf::Preset methods = plannedMethods(c.scene, c.settings, 0);
    const int width = c.settings.width, height = c.settings.height;
    std::vector<PixelTruth> truth(static_cast<std::size_t>(width * height));
    constexpr std::size_t kGrain = 8;
    parallelFor(truth.size(), kGrain, [&](std::size_t i) {
        const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
        const PixelInputs inputs = pixelInputs(c.scene, 0, c.camera, width, height, x, y);
        truth[i].radiance = pixelRadiance(methods, inputs);
        truth[i].decided = coverageIsDecided(inputs);
        if (truth[i].radiance && truth[i].decided)
            truth[i].condition = pixelCondition(methods, inputs);
    });
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

Image exactPicture(const std::vector<PixelTruth>& truth, const Settings& settings)
{
    Image image(settings.width, settings.height, 4);
    for (std::size_t i = 0; i < truth.size(); ++i)
        if (const auto& c = truth[i].radiance)
            for (int k = 0; k < 4; ++k)
                image.texels[4 * i + static_cast<std::size_t>(k)] = k == 3 ? 1.0f : static_cast<float>((*c)[k]);
    return image;
}

/// A case in which hardly anything is lit or seen, or coverage often hangs on a rounding, would pass for the wrong
/// reason.
std::string weakness(const std::vector<PixelTruth>& truth, const Settings& settings)
{
    constexpr double kLeastLight = 0.01;
    const auto covered = std::ranges::count_if(truth, [](const PixelTruth& t) { return t.decided && t.radiance; });
    const auto undecided = std::ranges::count_if(truth, [](const PixelTruth& t) { return !t.decided; });
    if (covered <= settings.width * settings.height / 4)
        return fmt::format("only {} pixels to compare", covered);
    if (undecided > settings.width / 4)
        return fmt::format("coverage of {} pixels hangs on a rounding", undecided);
    if (brightest(truth) <= kLeastLight)
        return "nothing is lit";
    return {};
}

PictureJudgement judgeShape(const PictureCase& c, const Image& drawn)
{
    const std::vector<PixelTruth> truth = truthOf(c);
    const double floor = kOfBrightest * brightest(truth);
    PictureJudgement judgement{.worst = {},
                               .fault = weakness(truth, c.settings),
                               .exact = exactPicture(truth, c.settings),
                               .excess = Image(drawn.width, drawn.height, 1)};
    for (int y = 0; y < drawn.height; ++y)
        for (int x = 0; x < drawn.width; ++x) {
            const PixelTruth& t = truth[static_cast<std::size_t>(y * drawn.width + x)];
            const float* p = drawn.at(x, y);
            if (!t.decided)
                continue;
            if (p[3] != (t.radiance ? 1.0f : 0.0f))
                judgement.fault = fmt::format("pixel ({}, {}) has coverage {}", x, y, p[3]);
            if (!t.radiance)
                continue;
            const dvec3 allowed = kRelative * glm::abs(*t.radiance) + floor + kConditionFactor * t.condition;
            *judgement.excess.at(x, y) =
                static_cast<float>(judgement.worst.note(x, y, dvec3(p[0], p[1], p[2]), *t.radiance, allowed));
        }
    return judgement;
}

const dvec3 kGold(1.0, 0.77, 0.34);

struct NamedMaterial
{
    const char* name;
    Material material;
};

const std::vector<NamedMaterial>& materials()
{
    static const std::vector<NamedMaterial> all = {
        {"smooth metal", plainMaterial(kGold, 1.0, 0.1)},
        {"rough metal", plainMaterial(kGold, 1.0, 0.6)},
        {"dielectric", plainMaterial(dvec3(0.8, 0.1, 0.2), 0.0, 0.25)},
        {"half metal", plainMaterial(dvec3(0.02, 0.5, 0.9), 0.5, 1.0)},
    };
    return all;
}

const char* nameOf(AnalyticShape::Kind kind)
{
    return kind == AnalyticShape::Kind::sphere ? "sphere" : "plane";
}

const char* nameOf(Light::Kind kind)
{
    switch (kind) {
    case Light::Kind::directional:
        return "directional";
    case Light::Kind::point:
        return "point";
    case Light::Kind::spot:
        break;
    }
    return "spot";
}

PictureCase makeCase(Scene scene, const brdf::Preset& preset, int size, std::string name)
{
    const Camera camera = fitCamera(scene, {0.3, 1.3}, 1.0, 0.7, 0.15);
    return {std::move(name), std::move(scene), camera, squareSettings(preset, size), judgeShape};
}

// The exact albedo behind compensation, and the integral behind uniform light, cost more than all the rest.
constexpr int kSize = 48, kCostlySize = 16;

int sizeFor(const brdf::Preset& preset)
{
    return brdf::isComposed(preset) && (preset.multipleScattering->readsAlbedo || preset.diffuseWeight->readsAlbedo)
               ? kCostlySize
               : kSize;
}

} // namespace

std::vector<PictureCase> shapeCases(AnalyticShape::Kind shape, Light::Kind light)
{
    std::vector<PictureCase> cases;
    for (const NamedMaterial& m : materials())
        for (const char* id : {"gltf", "standard"}) {
            const brdf::Preset& preset = *brdf::findPreset(id);
            Scene scene = shapeScene(shape, m.material);
            scene.lights.push_back(testLight(light));
            cases.push_back(makeCase(std::move(scene), preset, sizeFor(preset),
                                     fmt::format("{}, {} light, {}, {}", nameOf(shape), nameOf(light), id, m.name)));
        }
    return cases;
}

std::vector<PictureCase> shapeCasesInUniformLight(AnalyticShape::Kind shape)
{
    std::vector<PictureCase> cases;
    for (const NamedMaterial& m : materials())
        for (const char* id : {"gltf", "standard"}) {
            Scene scene = shapeScene(shape, m.material);
            scene.environment = uniformEnvironment(dvec3(0.9, 1.0, 1.2));
            cases.push_back(makeCase(std::move(scene), *brdf::findPreset(id), kCostlySize,
                                     fmt::format("{}, uniform light, {}, {}", nameOf(shape), id, m.name)));
        }
    return cases;
}

std::vector<PictureCase> presetSpheres(const brdf::Preset& preset)
{
    std::vector<PictureCase> cases;
    std::vector<NamedMaterial> chosen = materials();
    if (!brdf::isComposed(preset)) // where sources have their guards: some cap their D there
        chosen.push_back({"nearly a mirror", plainMaterial(dvec3(0.2, 0.5, 0.3), 0.0, 0.06)});
    for (const NamedMaterial& m : chosen) {
        Scene scene = shapeScene(AnalyticShape::Kind::sphere, m.material);
        scene.lights.push_back(testLight(Light::Kind::point));
        cases.push_back(makeCase(std::move(scene), preset, sizeFor(preset), fmt::format("{}, {}", preset.id, m.name)));
    }
    return cases;
}

} // namespace torrance
