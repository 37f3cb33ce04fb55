#include "study/method_cost.h"

#include "image/display.h"
#include "scene/camera_fit.h"
#include "scene/shape_mesh.h"
#include "study/analytic_scenes.h"
#include "study/bench_item.h"
#include "study/curve_error.h"
#include "study/slot_trial.h"
#include "study/sphere_set.h"

#include <algorithm>
#include <memory>

namespace torrance {
namespace {

using brdf::Method;

/// Of a picture's side: a frame of a GPU must take longer than what starting it takes.
int costSide(BenchClock clock)
{
    return clock == BenchClock::processor ? 160 : 2048;
}

// A ball so near that it fills the picture. Half a metal: every term of the shading has something to do.
Scene costScene(TrialScene trial, const Environment& environment)
{
    Scene scene;
    scene.name = "ball";
    scene.materials.push_back(plainMaterial(dvec3(0.8, 0.5, 0.3), 0.5, 0.6));
    scene.primitives.push_back(sphereMesh());
    scene.primitives.front().material = 0;
    scene.instances.push_back({});
    if (trial == TrialScene::environment)
        scene.environment = environment;
    else if (trial == TrialScene::uniform)
        scene.environment = uniformEnvironment(dvec3(1.0));
    else if (trial == TrialScene::areaLights)
        scene.lights.push_back(sphereAreaLights().front());
    else
        scene.lights.push_back(sphereLamps().front());
    if (trial == TrialScene::bumps)
        addBumps(scene);
    return scene;
}

Camera costCamera(const Scene& scene)
{
    constexpr double kDistance = 1.3, kFov = 40.0 * kPi / 180.0; // radii: the ball's edge is seen 50 degrees off
    return fitNearPlane(lookAtCamera(dvec3(0.0, 0.0, kDistance), dvec3(0.0), dvec3(0.0, 1.0, 0.0), kFov), scene);
}

Settings costSettings(const Method& method, int side)
{
    Settings settings;
    settings.methods = presetWith(method);
    settings.width = settings.height = side;
    settings.path = RenderPath::forward;
    settings.background = BackgroundKind::color;
    return settings;
}

using Draws = std::vector<std::function<TimeUse()>>;

std::vector<MethodCost> timed(const Draws& draws, double pixels, const BenchBounds& bounds, BenchClock clock)
{
    constexpr double kNanoseconds = 1e9;
    const std::vector<FrameTimes> frames = timeFrames(draws, bounds, clock);
    std::vector<MethodCost> costs;
    for (std::size_t i = 1; i < frames.size(); ++i) { // the first is what the others are compared with
        const std::vector<double>& times = frames[i].of(clock);
        const Estimate own = estimateMedian(times), ratio = estimatePairedRatio(frames.front().of(clock), times);
        const double unit = kNanoseconds / pixels;
        costs.push_back({.nanoseconds = {own.median * unit, own.low * unit, own.high * unit},
                         .ratio = {ratio.median, ratio.low, ratio.high},
                         .frames = times.size()});
    }
    return costs;
}

std::vector<MethodCost> frameCosts(const TrialDevice& on, const std::vector<const Method*>& methods,
                                   const Environment& environment, const BenchBounds& bounds,
                                   const std::function<void()>& checkpoint)
{
    const TrialScene trial = trialScene(methods.front()->slot);
    const int side = costSide(on.clock());
    std::vector<std::unique_ptr<BenchItem>> items;
    Draws draws;
    for (const Method* method : methods) {
        checkpoint();
        items.push_back(std::make_unique<BenchItem>(on.device, on.shaders, on.cacheFolder,
                                                    BenchSource{std::string(method->id),
                                                                [&] { return costScene(trial, environment); },
                                                                costCamera, costSettings(*method, side)}));
        draws.push_back([&checkpoint, item = items.back().get()] {
            checkpoint();
            return item->drawFrame();
        });
    }
    return timed(draws, double(side) * side, bounds, on.clock());
}

// Every colour once: what a curve costs does not depend on the picture, but for its branches.
Image colorsForCurves()
{
    constexpr int kSide = 512;
    Image colors(kSide, kSide, 3);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const float red = 4.0f * static_cast<float>(x) / kSide, green = 4.0f * static_cast<float>(y) / kSide;
            const float color[] = {red, green, static_cast<float>((x ^ y) % 64) / 16.0f};
            std::copy_n(color, 3, colors.at(x, y));
        }
    return colors;
}

std::vector<MethodCost> curveCosts(const std::vector<const Method*>& methods, const BenchBounds& bounds,
                                   const std::function<void()>& checkpoint)
{
    const Image colors = colorsForCurves();
    Draws draws;
    for (const Method* method : methods) {
        draws.push_back([&, settings = displayOf(*method)] {
            checkpoint();
            const TimeUse start = timeUse();
            toDisplay(colors, settings);
            return timeUse() - start;
        });
    }
    return timed(draws, double(colors.width) * colors.height, bounds, BenchClock::processor);
}

} // namespace

std::vector<MethodCost> measureCosts(const TrialDevice& on, const std::vector<const Method*>& methods,
                                     const Environment& environment, const BenchBounds& bounds,
                                     const std::function<void()>& checkpoint)
{
    std::vector<const Method*> drawn = {referenceMethod(methods.front()->slot)};
    drawn.insert(drawn.end(), methods.begin(), methods.end());
    return trialScene(drawn.front()->slot) == TrialScene::picture
               ? curveCosts(drawn, bounds, checkpoint)
               : frameCosts(on, drawn, environment, bounds, checkpoint);
}

} // namespace torrance
