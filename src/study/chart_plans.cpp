#include "study/chart_plans.h"

#include "files/csv_read.h"
#include "measure/pareto.h"
#include "study/tolerance_variant.h"

#include <algorithm>

#include <fmt/format.h>
#include <optional>

namespace torrance {
namespace {

std::vector<bool> frontOf(const std::vector<PlanResult>& results, bool both)
{
    std::vector<CostAndError> points;
    for (const PlanResult& r : results)
        points.push_back({r.milliseconds, r.shading + (both ? r.sampling : 0.0)});
    std::vector<bool> front(results.size(), false);
    for (const std::size_t i : paretoFront(points))
        front[i] = true;
    return front;
}

std::string percent(double share)
{
    return fmt::format("{:.3g} %", 100.0 * share);
}

// A tolerance's plan; where there is none, what is drawn by default.
bool isChosen(const PlanResult& result, const std::vector<PlanResult>& results)
{
    const bool hasTolerance = std::ranges::count(results, kToleranceKind, &PlanResult::kind) > 0;
    return hasTolerance ? result.kind == kToleranceKind : result.name == kStandardPlan;
}

ChartPanel frontPanel(const std::vector<PlanResult>& results, bool both, const std::vector<Tolerance>& tolerances)
{
    const std::vector<bool> front = frontOf(results, both);
    ChartPanel panel = {.id = both ? "both" : "shading",
                        .kind = ChartKind::front,
                        .title = both ? "Shading and sampling together" : "Shading",
                        .text = both ? "The sum of both parts: the most that they can come to."
                                     : "Against the exact light of the same surfaces. What samples and paths change "
                                       "is cost alone.",
                        .x = "ms a frame",
                        .y = "mean relative error",
                        .marks = {},
                        .columns = {},
                        .rows = {},
                        .frontRows = {}};
    if (!both) // a tolerance is of shading
        for (const Tolerance& tolerance : tolerances)
            panel.rules.push_back({toleranceName(tolerance), tolerance.mean});
    for (std::size_t i = 0; i < results.size(); ++i) {
        const PlanResult& r = results[i];
        panel.marks.push_back({.name = r.name,
                               .label = r.name,
                               .group = "front",
                               .x = r.milliseconds,
                               .interval = std::nullopt,
                               .y = r.shading + (both ? r.sampling : 0.0),
                               .front = front[i],
                               .chosen = isChosen(r, results),
                               .details = {{"shading", percent(r.shading)},
                                           {"sampling", percent(r.sampling)},
                                           {"ms a frame", fmt::format("{:.3g}", r.milliseconds)},
                                           {"times standard", fmt::format("{:.3g} [{:.3g}, {:.3g}]", r.ratio.median,
                                                                          r.ratio.low, r.ratio.high)}},
                               .picture = r.picture,
                               .error = r.error,
                               .citation = {}});
    }
    return panel;
}

ChartPanel barsPanel(const std::vector<PlanResult>& results)
{
    const std::vector<bool> front = frontOf(results, true);
    ChartPanel panel = {.id = "budget",
                        .kind = ChartKind::bars,
                        .title = "Where the error comes from",
                        .text =
                            "Shading: of formulas, tables and prefilters. Sampling: of few places in a pixel, against "
                            "many. Light between surfaces (transport) is measured by neither.",
                        .x = "mean relative error",
                        .y = "",
                        .marks = {},
                        .columns = {"plan", "ms a frame", "times standard", "shading", "sampling", "varies"},
                        .rows = {},
                        .frontRows = front};
    for (const PlanResult& r : results) {
        for (const auto& [part, value] : {std::pair("shading", r.shading), std::pair("sampling", r.sampling)})
            panel.marks.push_back({.name = r.name,
                                   .label = r.name,
                                   .group = part,
                                   .x = r.milliseconds,
                                   .interval = std::nullopt,
                                   .y = value,
                                   .front = false,
                                   .chosen = isChosen(r, results),
                                   .details = {{part, percent(value)}},
                                   .picture = {},
                                   .error = {},
                                   .citation = {}});
        panel.rows.push_back({r.name, fmt::format("{:.3g}", r.milliseconds),
                              fmt::format("{:.3g} [{:.3g}, {:.3g}]", r.ratio.median, r.ratio.low, r.ratio.high),
                              percent(r.shading), percent(r.sampling), r.kind});
    }
    return panel;
}

} // namespace

std::string plansCsv(const std::vector<PlanResult>& results)
{
    const std::vector<bool> front = frontOf(results, true);
    std::string text = "plan,kind,ms,ratio,ratio_low,ratio_high,shading,sampling,front\n";
    for (std::size_t i = 0; i < results.size(); ++i) {
        const PlanResult& r = results[i];
        text +=
            fmt::format("{},{},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{}\n", csvCell(r.name), r.kind, r.milliseconds,
                        r.ratio.median, r.ratio.low, r.ratio.high, r.shading, r.sampling, front[i] ? 1 : 0);
    }
    return text;
}

ChartPage plansPage(const std::string& scene, const std::string& about, const std::vector<PlanResult>& results,
                    const std::vector<Tolerance>& tolerances)
{
    return {
        .title = "What plans of " + scene + " cost, and how far off they are",
        .introduction =
            {about,
             "Each plan differs from the preset standard in one thing. Cost: its frames in turn with "
             "standard's. Shading error: the sum of |d - c| over that of |c|, d one sample a pixel and c "
             "the exact integral of the preset standard over the surfaces that the device found. "
             "Blended surfaces do not count. Coloured: on the front. Diamond: what a tolerance chooses, whose line the "
             "panel of shading has; without one, what is drawn by default."},
        .panels = {frontPanel(results, true, tolerances), frontPanel(results, false, tolerances), barsPanel(results)}};
}

} // namespace torrance
