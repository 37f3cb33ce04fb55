// The plans that one scene can be drawn with.
#pragma once

#include "plan/shading_plan.h"

#include <string>
#include <vector>

namespace torrance {

struct PlanVariant
{
    std::string name; // "environment_specular=vndf"; kStandardPlan for what nothing else is asked for
    std::string kind; // what is varied: "preset", "method", "samples", ...
    Settings settings;
    int environmentWidth = 0; // of the panorama; 0: as it is
};

inline constexpr const char* kStandardPlan = "standard";

/// `base`, the preset gltf, each method that can stand in one slot, directions and samples, sizes of the environment,
/// paths. `base` first. Plans that makePlan refuses are left out.
std::vector<PlanVariant> planVariants(const Scene& scene, const Settings& base);

} // namespace torrance
