// Whole plans of one scene: what a frame costs against how far it is from the exact shading, and from many samples.
#pragma once

#include "files/json_parse.h"
#include "study/chart_page.h"
#include "study/method_cost.h"
#include "study/surface_truth.h"

#include <optional>
#include <string>
#include <vector>

namespace torrance {

struct PlanVariant
{
    std::string name; // "environment_specular=vndf"; "standard" for what nothing else is asked for
    std::string kind; // what is varied: "preset", "method", "samples", ...
    Settings settings;
    int environmentWidth = 0; // of the panorama; 0: as it is
};

/// The plans that a scene can be drawn with: `base`, the preset gltf, each method that can stand in one slot,
/// directions and samples, sizes of the environment, paths. `base` first. Plans that makePlan refuses are left out.
std::vector<PlanVariant> planVariants(const Scene& scene, const Settings& base);

struct PlanResult
{
    std::string name;
    std::string kind;
    double milliseconds = 0.0; // a frame with its samples
    Measured ratio;            // to the first plan's, drawn in turn with it
    double shading = 0.0;      // sum |d - c|_1 over sum |c|_1 of one sample, c the exact light of the same surfaces
    double sampling = 0.0;     // of the plan's samples against many
    std::string picture;       // PNG in base64
    std::string error;
};

inline constexpr int kManyPlanSamples = 64;

/// One variant against `truth`; frames in turn with the first one's.
PlanResult measurePlan(const TrialDevice& on, const Scene& scene, const Camera& camera, const PlanVariant& first,
                       const PlanVariant& variant, const SurfaceTruth& truth, const BenchBounds& bounds,
                       const std::function<void()>& checkpoint);

Json asJson(const PlanResult& result);
PlanResult planResultFrom(const JsonView& json);

/// "plan,kind,ms,ratio,ratio_low,ratio_high,shading,sampling,front".
std::string plansCsv(const std::vector<PlanResult>& results);

/// Fronts of shading error and of both parts, and the parts as bars.
ChartPage plansPage(const std::string& scene, const std::string& about, const std::vector<PlanResult>& results);

} // namespace torrance
