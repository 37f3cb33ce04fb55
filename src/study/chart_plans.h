// Whole plans of one scene: what a frame costs against how far it is from the exact shading, and from many samples.
#pragma once

#include "plan/tolerance.h"
#include "study/chart_page.h"
#include "study/plan_result.h"

#include <string>
#include <vector>

namespace torrance {

/// "plan,kind,ms,ratio,ratio_low,ratio_high,shading,sampling,front".
std::string plansCsv(const std::vector<PlanResult>& results);

/// Fronts of shading error and of both parts, and the parts as bars. The tolerances, whose plans (toleranceName) are
/// among the results, are lines; their plans are marked, or the standard plan where there are none.
ChartPage plansPage(const std::string& scene, const std::string& about, const std::vector<PlanResult>& results,
                    const std::vector<Tolerance>& tolerances);

} // namespace torrance
