// The plan of one scene that a tolerance chooses, among the plans of its chart.
#pragma once

#include "plan/method_table.h"
#include "plan/tolerance.h"
#include "study/method_cost.h"
#include "study/plan_variants.h"
#include "study/tolerance_search.h"

namespace torrance {

inline constexpr const char* kToleranceKind = "tolerance";

/// "tolerance 1 %".
std::string toleranceName(const Tolerance& tolerance);

/// Draws as drawWithin asks. The variant's name says so where the tolerance is out of reach; it is the nearest that was
/// found then.
PlanVariant toleranceVariant(const TrialDevice& on, const Scene& scene, const Camera& camera, const Settings& asked,
                             const MethodTable& table, const Tolerance& tolerance, const Checkpoint& checkpoint);

} // namespace torrance
