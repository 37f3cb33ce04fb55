#include "study/scene_trial.h"

#include <fmt/format.h>

namespace torrance {
namespace {

std::string result(const SceneTrial& trial)
{
    return !trial.applies ? "does not apply" : trial.passed() ? "pass" : "FAIL";
}

HtmlMark mark(const SceneTrial& trial)
{
    return !trial.applies ? HtmlMark::none : trial.passed() ? HtmlMark::good : HtmlMark::bad;
}

} // namespace

HtmlReport sceneTrialReport(const std::string& scene, const std::string& device, std::span<const SceneTrial> trials)
{
    HtmlReport report = {.title = "Stability of " + scene, .parts = {}};
    report.parts.emplace_back(HtmlParagraph{"Drawn on " + device + "."});
    HtmlTable table = {.columns = {"trial", "measured", "allowed", "quantity", "result"}, .rows = {}};
    for (const SceneTrial& trial : trials)
        table.rows.push_back({HtmlCell(trial.name),
                              HtmlCell(trial.applies ? fmt::format("{:.3g}", trial.measured) : ""),
                              HtmlCell(trial.applies ? fmt::format("{:.3g}", trial.allowed) : ""),
                              HtmlCell(trial.quantity), HtmlCell(result(trial), mark(trial))});
    report.parts.emplace_back(std::move(table));
    for (const SceneTrial& trial : trials) {
        report.parts.emplace_back(HtmlHeading{trial.name});
        report.parts.emplace_back(HtmlParagraph{trial.expectation});
        if (!trial.pictures.empty())
            report.parts.emplace_back(HtmlPictures{trial.pictures});
    }
    return report;
}

} // namespace torrance
