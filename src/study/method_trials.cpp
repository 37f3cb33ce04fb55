#include "study/method_trials.h"

#include "image/display.h"
#include "passes/renderer.h"
#include "study/analytic_scenes.h"
#include "study/curve_error.h"
#include "study/error_picture.h"
#include "study/slot_trial.h"
#include "study/sphere_error.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace torrance {
namespace {

using brdf::Method;
using brdf::Preset;
using brdf::Slot;

constexpr int kManySamples = 256;

Scene litSpheres(const MethodGrid& grid, TrialScene trial, const Environment& environment, SphereBodies bodies)
{
    Scene scene = trial == TrialScene::bumps ? bumpySphereSet(grid) : sphereSet(grid, bodies);
    if (trial == TrialScene::environment || trial == TrialScene::picture)
        scene.environment = environment;
    else if (trial == TrialScene::uniform)
        scene.environment = uniformEnvironment(dvec3(1.0));
    else
        scene.lights = trial == TrialScene::areaLights ? sphereAreaLights() : sphereLamps();
    return scene;
}

// The methods of every material as the plan has them: the compensation that it leaves out is no error of other slots.
std::vector<Preset> plannedPresets(const Scene& scene, const Settings& settings)
{
    const ShadingPlan plan = makePlan(scene, settings);
    std::vector<Preset> presets;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        presets.push_back(settings.methods);
        if (presets.back().multipleScattering && !plan.materials[i].compensates)
            presets.back().multipleScattering = brdf::findMethod(Slot::multipleScattering, "none");
    }
    return presets;
}

// Draws a slot's spheres and knows what they should look like.
class SlotSpheres
{
public:
    SlotSpheres(const TrialDevice& device, Slot trialSlot, const TrialOptions& trialOptions)
        : on(device), slot(trialSlot), options(trialOptions), grid(sphereGrid()),
          scene(litSpheres(grid, trialScene(slot), options.environment,
                           slot == Slot::environmentSpecular ? SphereBodies::black : SphereBodies::colored))
    {
        // The body's light alone is what coloured spheres have more than black ones.
        if (slot == Slot::environmentDiffuse)
            without = litSpheres(grid, trialScene(slot), options.environment, SphereBodies::black);
    }

    Image draw(const Preset& methods) const
    {
        Image color = drawScene(scene, sphereSettings(grid, methods));
        if (without) {
            const Image rest = drawScene(*without, sphereSettings(grid, methods));
            for (std::size_t i = 0; i < color.texels.size(); ++i)
                if (i % 4 != 3)
                    color.texels[i] -= rest.texels[i];
        }
        return color;
    }

    const SphereTruth& truth(const Method& method)
    {
        const MethodTruth kind = truthOf(method);
        const auto found = truths.find(kind.text);
        return found != truths.end() ? found->second : truths.emplace(kind.text, computed(kind)).first->second;
    }

    const MethodGrid& gridOf() const { return grid; }

private:
    Image drawScene(const Scene& what, const Settings& settings) const
    {
        Renderer renderer(on.device, on.shaders, on.cacheFolder);
        if (what.shapes.empty())
            return drawPart(renderer, what, sphereCamera(grid), settings);
        Image picture(settings.width, settings.height, 4);
        const int columns = static_cast<int>(grid.roughnesses.size());
        Scene one = what; // with its light and materials
        Settings part = settings;
        part.width = part.height = kSphereCell;
        for (int i = 0; i < static_cast<int>(what.shapes.size()); ++i) {
            one.shapes = {what.shapes[static_cast<std::size_t>(i)]};
            const int column = i % columns, row = i / columns;
            const Image cell = drawPart(renderer, one, cellCamera(grid, column, row), part);
            for (int y = 0; y < kSphereCell; ++y)
                std::copy_n(cell.at(0, y), 4 * kSphereCell, picture.at(column * kSphereCell, row * kSphereCell + y));
        }
        return picture;
    }

    Image drawPart(Renderer& renderer, const Scene& what, const Camera& camera, const Settings& settings) const
    {
        const ShadingPlan plan = makePlan(what, settings);
        const DeviceScene uploaded = renderer.upload(what, plan);
        return renderer.render(uploaded, camera, [&](int, int) { options.checkpoint(); }).color;
    }

    SphereTruth computed(const MethodTruth& kind) const
    {
        const Preset& standard = *brdf::findPreset("standard");
        switch (kind.kind) {
        case TruthKind::formula:
            return byFormula(presetWith(*kind.method));
        case TruthKind::fresnel:
            return byExactFresnel();
        case TruthKind::walks: {
            Preset once = standard;
            once.multipleScattering = brdf::findMethod(Slot::multipleScattering, "none");
            return walkTruth(grid, scene, once, options.checkpoint);
        }
        case TruthKind::integral: {
            if (!without)
                return integralTruth(grid, scene, standard, SpheresWithLight::all, options.checkpoint);
            constexpr SpheresWithLight kBodies = SpheresWithLight::dielectrics;
            return difference(integralTruth(grid, scene, standard, kBodies, options.checkpoint),
                              integralTruth(grid, *without, standard, kBodies, options.checkpoint));
        }
        case TruthKind::albedo: {
            const std::vector<Preset> presets = plannedPresets(scene, sphereSettings(grid, standard));
            return uniformTruth(
                grid, scene, [&](std::size_t i) -> const Preset& { return presets[i]; }, options.checkpoint);
        }
        case TruthKind::supersampled:
            return bySamples(standard);
        case TruthKind::none:
            break;
        }
        return {};
    }

    SphereTruth byFormula(const Preset& preset) const
    {
        const std::vector<Preset> presets = plannedPresets(scene, sphereSettings(grid, preset));
        return lampTruth(
            grid, scene, [&](std::size_t i) -> const Preset& { return presets[i]; }, options.checkpoint);
    }

    SphereTruth byExactFresnel() const
    {
        std::vector<Preset> presets = plannedPresets(scene, sphereSettings(grid, *brdf::findPreset("standard")));
        for (std::size_t i = 0; i < presets.size(); ++i)
            presets[i].fresnel = brdf::findMethod(
                Slot::fresnel, scene.materials[i].metallicFactor > 0.0 ? "exact_conductor" : "exact_dielectric");
        return lampTruth(
            grid, scene, [&](std::size_t i) -> const Preset& { return presets[i]; }, options.checkpoint);
    }

    SphereTruth bySamples(const Preset& standard) const
    {
        Settings settings = sphereSettings(grid, standard);
        settings.samples = kManySamples;
        const Image drawn = drawScene(scene, settings);
        SphereTruth truth = {Image(drawn.width, drawn.height, 3), {}};
        for (int y = 0; y < drawn.height; ++y)
            for (int x = 0; x < drawn.width; ++x)
                if (spherePixel(grid, x, y))
                    std::copy_n(drawn.at(x, y), 3, truth.color.at(x, y));
        return truth;
    }

    const TrialDevice& on;
    Slot slot;
    const TrialOptions& options;
    MethodGrid grid;
    Scene scene;
    std::optional<Scene> without;
    std::map<std::string, SphereTruth> truths;
};

void judgeCurve(const Image& colors, MethodRow& row, MethodPictures& pictures)
{
    pictures.drawn = toDisplay(colors, displayOf(*row.method));
    const MethodTruth truth = truthOf(*row.method);
    if (truth.kind == TruthKind::none)
        return;
    const CurveJudgement judgement = judgeCurve(colors, *row.method, *truth.method);
    row.error = judgement.error;
    pictures.error = errorPicture(judgement.pixels);
}

void judge(SlotSpheres& spheres, MethodRow& row, MethodPictures& pictures)
{
    const Image drawn = spheres.draw(presetWith(*row.method));
    pictures.drawn = toDisplay(drawn, {});
    if (truthOf(*row.method).kind == TruthKind::none)
        return;
    const SphereJudgement judgement = judgeSpheres(spheres.gridOf(), spheres.truth(*row.method), drawn);
    row.error = judgement.error;
    pictures.error = errorPicture(judgement.pixels);
}

} // namespace

MeasuredSlot measureSlot(const TrialDevice& on, Slot slot, const TrialOptions& options)
{
    MeasuredSlot result;
    result.slot = slot;
    std::vector<const Method*> drawn;
    for (const Method* method : methodsOf(slot)) {
        const MethodTruth truth = truthOf(*method);
        std::string note = whyNotOnSpheres(*method);
        if (note.empty())
            drawn.push_back(method);
        if (note.empty() && truth.kind == TruthKind::none)
            note = truth.text;
        result.rows.push_back({.method = method,
                               .truth = truth.kind == TruthKind::none ? "" : truth.text,
                               .note = note,
                               .cost = {},
                               .error = {}});
    }
    result.pictures.resize(result.rows.size());
    if (drawn.empty())
        return result;
    const std::vector<MethodCost> costs =
        measureCosts(on, drawn, options.environment, options.bounds, options.checkpoint);
    const Slot spheresSlot = slot;
    SlotSpheres spheres(on, spheresSlot, options);
    const bool isCurve = trialScene(slot) == TrialScene::picture;
    const Image colors = isCurve ? spheres.draw(*brdf::findPreset("standard")) : Image();
    for (std::size_t i = 0, next = 0; i < result.rows.size(); ++i) {
        options.checkpoint();
        if (next == drawn.size() || result.rows[i].method != drawn[next])
            continue;
        result.rows[i].cost = costs[next++];
        if (isCurve)
            judgeCurve(colors, result.rows[i], result.pictures[i]);
        else
            judge(spheres, result.rows[i], result.pictures[i]);
    }
    return result;
}

} // namespace torrance
