// What one plan of a scene costs, and how far it is from the exact shading and from many samples.
#pragma once

#include "files/json_parse.h"
#include "study/method_cost.h"
#include "study/plan_variants.h"
#include "study/surface_truth.h"

#include <functional>
#include <string>

namespace torrance {

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

} // namespace torrance
